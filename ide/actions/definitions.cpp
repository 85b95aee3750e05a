#include "ide/actions/action.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace proskill::ide {

namespace {

constexpr std::array<std::string_view, 22> kOrder{
    ":states",    ":init",          ":min",       ":max",    ":transitions",  ":capacity",
    ":every",     ":guard",         ":effects",   ":input",  ":precondition", ":start",
    ":invariant", ":time_interval", ":resources", ":action", ":interrupt",    ":interruptible",
    ":success",   ":failure",       ":monitor",   ":body"};

std::size_t rankOf(const syntax::FieldUse& field) {
  return static_cast<std::size_t>(std::ranges::find(kOrder, field.keyword.text) - kOrder.begin());
}

const syntax::List<syntax::FieldUse>* fieldUses(const syntax::Form& form) {
  return std::visit(
      [](const auto& node) -> const syntax::List<syntax::FieldUse>* {
        if constexpr (requires { node.fields; } &&
                      !std::is_same_v<std::decay_t<decltype(node)>, syntax::Property>)
          return &node.fields;
        return nullptr;
      },
      form.node());
}

/// A field with the comments before it and those after it on its line.
struct Chunk {
  syntax::Range range;
  std::size_t rank = 0;
};

std::vector<Chunk> chunksOf(const ActionContext& context,
                            const syntax::List<syntax::FieldUse>& fields) {
  const auto& comments = context.view.document().comments();
  std::vector<Chunk> chunks;
  for (const auto& field : fields) {
    auto end = field.range.end;
    auto comment = std::ranges::find_if(
        comments, [&](syntax::Range candidate) { return candidate.begin >= end; });
    bool trails =
        comment != comments.end() &&
        context.textOf({end, comment->begin}).find_first_not_of(" \t") == std::string_view::npos;
    if (trails) end = comment->end;
    auto begin = chunks.empty() ? field.range.begin : chunks.back().range.end;
    chunks.push_back({{begin, end}, rankOf(field)});
  }
  return chunks;
}

/// All moves between different values.
std::string allPairs(const syntax::List<syntax::Name>& states) {
  std::string list;
  for (const auto& from : states) {
    for (const auto& to : states)
      if (&from != &to) list += fmt::format("({} {}) ", from.text, to.text);
    if (!list.empty()) list.back() = '\n';
  }
  return fmt::format("({})", list.substr(0, list.size() - 1));
}

/// Whether a list allows the same moves as `:all`, and names each once.
bool listsAll(const syntax::StateVariable& variable) {
  std::set<std::pair<std::string_view, std::string_view>> moves;
  for (const auto& move : variable.transitions)
    if (move.from.text != move.to.text) moves.insert({move.from.text, move.to.text});
  auto count = variable.states.size();
  return moves.size() == count * (count - 1) && count > 0;
}

} // namespace

void addTransitions(const ActionContext& context, Actions& actions) {
  constexpr std::size_t kMostStates = 12; // with more values the list would be unreadable
  const auto* form = context.form();
  const auto* variable = form ? form->as<syntax::StateVariable>() : nullptr;
  if (!variable || variable->states.size() < 2) return;
  auto field = std::ranges::find(variable->fields, ":transitions",
                                 [](const syntax::FieldUse& use) { return use.keyword.text; });
  if (field == variable->fields.end()) return;
  syntax::Range value{field->keyword.range.end, field->range.end};
  if (context.textOf(value).contains(';')) return;
  bool isAll = variable->transitionsKind == syntax::Transitions::All;
  if (isAll && variable->states.size() <= kMostStates)
    addLaidOut(context, actions, "List all transitions", ActionKind::RefactorRewrite,
               {{value, " " + allPairs(variable->states)}});
  if (variable->transitionsKind == syntax::Transitions::Listed && listsAll(*variable))
    addLaidOut(context, actions, "Write the transitions as `:all`", ActionKind::RefactorRewrite,
               {{value, " :all"}});
}

/// Adds a monitor of the selected value, or of the last one.
void addMonitor(const ActionContext& context, Actions& actions) {
  const auto* form = context.form();
  const auto* variable = form ? form->as<syntax::StateVariable>() : nullptr;
  if (!variable || !variable->name || variable->states.empty()) return;
  auto selected = std::ranges::find_if(variable->states, [&](const syntax::Name& state) {
    return state.range.begin <= context.selection.begin && context.selection.end <= state.range.end;
  });
  auto value = (selected == variable->states.end() ? variable->states.back() : *selected).text;
  auto name = fmt::format("monitor_{}", variable->name.text);
  if (context.view.program().skills.find(name)) return;
  auto condition = fmt::format("({} {})", variable->name.text, value);
  addLaidOut(context, actions, fmt::format("Generate a monitor of `{}`", condition),
             ActionKind::RefactorRewrite,
             {{{form->range.end, form->range.end},
               fmt::format("\n\n(defskill {}\n  :monitor t\n  :body\n((while true (^ {})\n"
                           "(printf \"{} is {}\") (^ (not {})))))",
                           name, condition, variable->name.text, value, condition)}});
}

void addSortFields(const ActionContext& context, Actions& actions) {
  const auto* form = context.form();
  const auto* fields = form ? fieldUses(*form) : nullptr;
  if (!fields || fields->size() < 2) return;
  auto chunks = chunksOf(context, *fields);
  auto sorted = chunks;
  std::ranges::stable_sort(sorted, {}, &Chunk::rank);
  bool unknown = sorted.back().rank >= kOrder.size();
  bool same = std::ranges::is_sorted(chunks, {}, &Chunk::rank);
  bool twice = std::ranges::adjacent_find(sorted, {}, &Chunk::rank) != sorted.end();
  if (unknown || same || twice) return;
  std::string text;
  for (const Chunk& chunk : sorted) {
    auto words = context.textOf(chunk.range);
    text += words.substr(words.find_first_not_of(" \t\r\n"));
    text += '\n';
  }
  addLaidOut(context, actions, "Sort the fields", ActionKind::SourceOrganizeFields,
             {{{chunks.front().range.begin, chunks.back().range.end}, text}});
}

} // namespace proskill::ide
