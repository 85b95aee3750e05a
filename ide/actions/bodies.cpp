#include "ide/actions/statements.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace proskill::ide {

namespace {

using syntax::StatementKind;

/// The selected statement, if the selection is exactly one that was parsed.
const syntax::Statement* onlyStatement(const Selected& selected) {
  bool one =
      selected.statements.size() == 1 && selected.statements.front().kind != StatementKind::Unknown;
  return one ? &selected.statements.front() : nullptr;
}

const syntax::Skill* skillOf(const ActionContext& context, std::string_view name) {
  const auto* found = context.view.program().skills.find(name);
  return found ? &found->node() : nullptr;
}

std::string unusedName(const ActionContext& context, const std::string& wish) {
  std::string name = wish;
  for (int i = 2; skillOf(context, name); ++i) name = fmt::format("{}_{}", wish, i);
  return name;
}

bool isNameLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

/// The inputs of a skill that a text mentions, in order; nullopt if it mentions others, or has a
/// `$` without a name.
std::optional<syntax::List<syntax::Input>> inputsIn(std::string_view text,
                                                    const syntax::Skill& skill) {
  std::set<std::string_view> mentioned;
  for (auto at = text.find('$'); at != std::string_view::npos; at = text.find('$', at + 1)) {
    auto end = at + 1;
    while (end < text.size() && isNameLetter(text[end])) ++end;
    mentioned.insert(text.substr(at, end - at));
  }
  syntax::List<syntax::Input> inputs;
  for (const auto& input : skill.inputs)
    if (mentioned.erase(input.name.text) > 0) inputs.push_back(input);
  return mentioned.empty() ? std::optional(std::move(inputs)) : std::nullopt;
}

/// Whether a skill consists of its body only: no time, conditions or outcomes.
bool isPlain(const syntax::Skill& skill) {
  return skill.body && !skill.body->statements.empty() && skill.fields.size() == 1 &&
         !contains(skill.body->statements,
                   {StatementKind::Success, StatementKind::Failure, StatementKind::Label,
                    StatementKind::Goto, StatementKind::Unknown}) &&
         !breaksOut(skill.body->statements);
}

/// Whether a skill is only called: nothing reads its outcome or interrupts it.
bool isOnlyCalled(const ActionContext& context, std::string_view name) {
  const auto& index = context.view.index();
  auto symbol = index.symbols().find(analysis::SymbolKind::Skill, name);
  if (symbol == analysis::kNoSymbol) return false;
  return std::ranges::all_of(index.occurrencesOf(symbol), [](const analysis::Occurrence& place) {
    return place.role == analysis::Role::Call || place.role == analysis::Role::Definition;
  });
}

} // namespace

/// Adds a branch for failure after a call of a skill that can fail. If there is a finding about
/// this, its fix is offered instead.
void addFailureBranch(const ActionContext& context, Actions& actions) {
  auto selected = selectedStatements(context);
  const auto* call = onlyStatement(selected);
  if (!call || call->kind != StatementKind::Call) return;
  const auto* skill = skillOf(context, call->head.text);
  if (!skill || (skill->failures.empty() && skill->invariants.empty())) return;
  const bool isTold = std::ranges::any_of(actions, [&](const Action& action) {
    return action.fixes && action.fixes->code == syntax::Code::ResultIgnored &&
           action.fixes->location.range == call->head.range;
  });
  if (isTold) return;
  auto next = context.textOf({call->range.end, selected.form->range.end});
  auto first = next.find_first_not_of(" \t\r\n");
  bool looksAlready = next.substr(std::min(first, next.size())).starts_with("(if") &&
                      next.substr(first, 200).contains(fmt::format("{}.", call->head.text));
  if (looksAlready) return;
  const auto& own = selected.skill->failures;
  auto reaction = own.empty() || own.front().tag.text.empty()
                      ? fmt::format("(printf \"{} has failed\")", call->head.text)
                      : fmt::format("(failure {})", own.front().tag.text);
  addLaidOut(context, actions, fmt::format("Add what happens when `{}` fails", call->head.text),
             ActionKind::RefactorRewrite,
             {{{call->range.end, call->range.end},
               fmt::format("\n(if (/= {}.status success)\n{})", call->head.text, reaction)}});
}

/// Wraps the selection in an `if` whose condition is true, so that nothing changes until the user
/// edits it.
void addWrapInIf(const ActionContext& context, Actions& actions) {
  auto selected = selectedStatements(context);
  if (selected.statements.empty() ||
      contains(selected.statements, {StatementKind::Label, StatementKind::Unknown}))
    return;
  auto range = selected.range();
  addLaidOut(context, actions, "Wrap in `if`", ActionKind::RefactorRewrite,
             {{{range.begin, range.begin}, "(if true\n"}, {{range.end, range.end}, "\n)"}});
}

/// Statements that end their skill or jump cannot be moved to another skill. Inputs that the
/// selection needs are passed on by name.
void addExtractSkill(const ActionContext& context, Actions& actions) {
  auto selected = selectedStatements(context);
  if (selected.statements.empty() || context.selection.empty()) return;
  bool bound = contains(selected.statements,
                        {StatementKind::Success, StatementKind::Failure, StatementKind::Label,
                         StatementKind::Goto, StatementKind::Unknown}) ||
               breaksOut(selected.statements);
  auto words = context.textOf(selected.range());
  // a comment after the last statement would swallow the call's parenthesis
  auto inputs = inputsIn(words, *selected.skill);
  if (bound || !inputs || !selected.skill->name) return;
  auto name = unusedName(context, fmt::format("part_of_{}", selected.skill->name.text));
  std::string declared;
  std::string handedOn;
  for (const auto& input : *inputs) {
    declared +=
        fmt::format("{}{} {}", declared.empty() ? "" : " ", input.name.text, input.type.text);
    handedOn += fmt::format(" {} {}", analysis::withoutDollar(input.name).text, input.name.text);
  }
  if (!declared.empty()) declared = fmt::format("\n:input ({})", declared);
  auto definition = fmt::format("(defskill {}{}\n  :body\n({}))\n\n", name, declared, words);
  auto before =
      selected.form->comment.empty() ? selected.form->range.begin : selected.form->comment.begin;
  addLaidOut(
      context, actions, fmt::format("Extract into the skill `{}`", name),
      ActionKind::RefactorExtract,
      {{{before, before}, definition}, {selected.range(), fmt::format("({}{})", name, handedOn)}});
}

void addInlineSkill(const ActionContext& context, Actions& actions) {
  auto selected = selectedStatements(context);
  const auto* call = onlyStatement(selected);
  if (!call || call->kind != StatementKind::Call || !call->arguments.empty()) return;
  const auto* definition = context.view.program().skills.find(call->head.text);
  if (!definition || &definition->node() == selected.skill || !isPlain(definition->node()) ||
      definition->form->recovered || !isOnlyCalled(context, call->head.text))
    return;
  const auto& text = context.view.program().files[definition->file].document.text();
  auto body = definition->node().body->range;
  auto words = std::string_view(text).substr(body.begin + 1, body.length() - 2);
  words = words.substr(0, words.find_last_not_of(" \t\r\n") + 1);
  // a comment at the end would swallow what follows the call
  const bool needsLine =
      words.contains(';') && !context.view.text().substr(call->range.end).starts_with('\n');
  addLaidOut(context, actions, fmt::format("Inline `{}`", call->head.text),
             ActionKind::RefactorInline,
             {{call->range, needsLine ? fmt::format("{}\n", words) : std::string(words)}});
}

} // namespace proskill::ide
