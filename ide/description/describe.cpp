#include "ide/description/describe.h"

#include "ide/snapshot/uses.h"
#include "syntax/text/scan.h"

#include <algorithm>
#include <fmt/format.h>
#include <ranges>

namespace proskill::ide {

namespace {

using analysis::Occurrence;
using analysis::Role;
using analysis::Symbol;
using analysis::SymbolId;
using analysis::SymbolKind;

constexpr std::size_t kMostLines = 24; ///< limit of lines of a definition
constexpr std::size_t kMostMoves = 16; ///< limit of rows of the table

const Symbol& symbolAt(const View& view, SymbolId id) { return view.index().symbols()[id]; }

std::string_view textOf(const View& view, analysis::FileId file, syntax::Range range) {
  return std::string_view(view.program().files[file].document.text())
      .substr(range.begin, range.length());
}

const syntax::StateVariable& variableOf(const View& view, const Symbol& symbol) {
  return view.program().stateVariables.all[symbol.definition].node();
}

const syntax::Skill& skillOf(const View& view, const Symbol& symbol) {
  return view.program().skills.all[symbol.definition].node();
}

/// As written.
std::string_view numberOf(const View& view, const Symbol& symbol) {
  const auto& constant = view.program().constants.all[symbol.definition];
  return textOf(view, symbol.at.file, constant->value.range);
}

std::string listed(const auto& parts, auto&& text) {
  std::string result;
  for (const auto& part : parts) {
    if (!result.empty()) result += ' ';
    result += text(part);
  }
  return result;
}

std::string inputsOf(const syntax::Skill& skill) {
  std::string result;
  for (const auto& input : skill.inputs)
    result += fmt::format(" {} {}", analysis::withoutDollar(input.name).text, input.type.text);
  return result;
}

std::string numberText(const std::optional<syntax::Expr>& expr) {
  if (!expr) return "?";
  if (expr->kind == syntax::ExprKind::Symbol) return std::string(expr->name.text);
  return expr->kind == syntax::ExprKind::Number ? syntax::toString(expr->number) : "?";
}

/// The beginning of a long definition; a composite skill without its body.
std::string shortened(std::string text) {
  std::size_t end = 0;
  for (std::size_t line = 0; line < kMostLines; ++line) {
    end = text.find('\n', end);
    if (end == std::string::npos) return text;
    ++end;
  }
  return text.substr(0, end) + "  …";
}

std::string codeOfSkill(const View& view, const Symbol& symbol) {
  const auto& skill = skillOf(view, symbol);
  auto body = std::ranges::find(skill.fields, ":body",
                                [](const syntax::FieldUse& use) { return use.keyword.text; });
  if (!skill.body || body == skill.fields.end())
    return std::string(textOf(view, symbol.at.file, symbol.extent));
  const auto head = syntax::Range{symbol.extent.begin, body->keyword.range.end};
  return std::string(textOf(view, symbol.at.file, head)) + " (…))";
}

std::string codeOf(const View& view, const Symbol& symbol) {
  if (symbol.kind == SymbolKind::Skill) return shortened(codeOfSkill(view, symbol));
  return shortened(std::string(textOf(view, symbol.at.file, symbol.extent)));
}

void describeMoves(Markup& text, const syntax::StateVariable& variable) {
  if (variable.isNatural()) return;
  if (variable.transitionsKind != syntax::Transitions::Listed)
    return text.prose("It may go from any value to any other.");
  std::vector<std::vector<std::string>> rows{{"from", "to"}};
  for (const auto& state : variable.states) {
    if (rows.size() > kMostMoves) {
      rows.push_back({"…", "…"});
      break;
    }
    std::string targets;
    for (const auto& move : variable.transitions)
      if (move.from.text == state.text)
        targets += fmt::format("{}`{}`", targets.empty() ? "" : ", ", move.to.text);
    rows.push_back({fmt::format("`{}`", state.text), targets.empty() ? "—" : targets});
  }
  text.table(rows);
}

bool reads(const View&, const Occurrence& place) { return place.role == Role::Read; }
bool calls(const View&, const Occurrence& place) { return place.role == Role::Call; }
bool uses(const View&, const Occurrence&) { return true; }

void describeUsers(Markup& text, const View& view, SymbolId id) {
  auto say = [&](std::string_view what, auto matters) {
    auto users = usersOf(view, id, matters);
    if (!users.empty()) text.prose(fmt::format("{} {}.", what, enumerate(view, users)));
  };
  switch (symbolAt(view, id).kind) {
  case SymbolKind::StateVariable: say("Set by", isSetting); return say("Read by", reads);
  case SymbolKind::Value: return say("Set by", isSetting);
  case SymbolKind::Skill: return say("Called by", calls);
  case SymbolKind::Event:
  case SymbolKind::Constant:
  case SymbolKind::Resource: return say("Used by", uses);
  default: return;
  }
}

/// "a value of `battery`", "an input of `takeoff`, a `float`".
std::string whatItIs(const View& view, const Symbol& symbol) {
  const auto owner = symbolAt(view, symbol.owner).name;
  switch (symbol.kind) {
  case SymbolKind::Value: return fmt::format("A value of `{}`.", owner);
  case SymbolKind::Parameter: return fmt::format("An input of `{}`.", owner);
  case SymbolKind::PreconditionTag:
    return fmt::format("A precondition of `{}`: it must hold when the skill is called.", owner);
  case SymbolKind::InvariantTag:
    return fmt::format("An invariant of `{}`: it must hold while the skill runs.", owner);
  case SymbolKind::SuccessTag: return fmt::format("A success of `{}`.", owner);
  case SymbolKind::FailureTag: return fmt::format("A failure of `{}`.", owner);
  case SymbolKind::Label: return fmt::format("A label of `{}`.", owner);
  default: return {};
  }
}

/// Describes the type of a symbol whose type is a state variable, with the values.
void describeType(Markup& text, const View& view, const Symbol& symbol) {
  if (symbol.kind != SymbolKind::Parameter) return;
  const auto& skill = skillOf(view, symbolAt(view, symbol.owner));
  auto input = std::ranges::find_if(skill.inputs, [&](const syntax::Input& candidate) {
    return analysis::withoutDollar(candidate.name).text == symbol.name;
  });
  if (input == skill.inputs.end()) return;
  const auto type = view.index().symbols().find(SymbolKind::StateVariable, input->type.text);
  if (type == analysis::kNoSymbol) return;
  text.prose(fmt::format("`{}` is one of: {}", input->type.text,
                         valuesOf(variableOf(view, symbolAt(view, type)))));
}

} // namespace

std::string valuesOf(const syntax::StateVariable& variable) {
  if (variable.isNatural())
    return fmt::format("{}..{}", numberText(variable.min), numberText(variable.max));
  return listed(variable.states, [](const syntax::Name& name) { return name.text; });
}

std::string signature(const View& view, SymbolId id) {
  const Symbol& symbol = symbolAt(view, id);
  switch (symbol.kind) {
  case SymbolKind::StateVariable:
    return fmt::format("{}: {}", symbol.name, valuesOf(variableOf(view, symbol)));
  case SymbolKind::Skill:
    return fmt::format("({}{})", symbol.name, inputsOf(skillOf(view, symbol)));
  case SymbolKind::Constant: return fmt::format("{} = {}", symbol.name, numberOf(view, symbol));
  case SymbolKind::Event:
  case SymbolKind::Resource:
  case SymbolKind::Property:
  case SymbolKind::Environment:
    return fmt::format("{} {}", analysis::words(symbol.kind), symbol.name);
  default: return std::string(textOf(view, symbol.at.file, symbol.extent));
  }
}

std::string commentAbove(const View& view, SymbolId id) {
  const Symbol& symbol = symbolAt(view, id);
  const auto& document = view.program().files[symbol.at.file].document;
  auto line = document.lines().position(symbol.extent.begin).line;
  std::vector<std::string_view> lines;
  while (line-- > 0) {
    const auto range = document.lines().line(line, document.text());
    const auto comment = syntax::commentLine(textOf(view, symbol.at.file, range));
    if (!comment) break;
    lines.push_back(*comment);
  }
  std::ranges::reverse(lines);
  std::string result;
  for (auto each : lines) result += (result.empty() ? "" : "\n") + std::string(each);
  return result;
}

void describe(Markup& text, const View& view, SymbolId id) {
  const Symbol& symbol = symbolAt(view, id);
  text.code(codeOf(view, symbol));
  if (auto comment = commentAbove(view, id); !comment.empty()) text.prose(comment);
  if (symbol.owner != analysis::kNoSymbol) text.prose(whatItIs(view, symbol));
  describeType(text, view, symbol);
  if (symbol.kind == SymbolKind::StateVariable) describeMoves(text, variableOf(view, symbol));
  describeUsers(text, view, id);
}

} // namespace proskill::ide
