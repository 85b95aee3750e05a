#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

/// Finds postconditions that are false in every state in which their outcome is returned.
namespace proskill::analysis::flow {

namespace {

/// The states in which an outcome is returned, over all its nodes.
struct Returned {
  ProcessId process = kNoProcess;
  std::vector<State> after;
};

/// The variable and the value of `(motion Free)`, `(= motion Free)`, `(= count 3)`.
struct Expected {
  std::string_view variable;
  syntax::Range value;
};

std::optional<Expected> expectedBy(const syntax::Expr& condition) {
  using syntax::ExprKind;
  auto isConstant = [](const syntax::Expr& value) {
    return value.kind == ExprKind::Symbol || value.kind == ExprKind::Number;
  };
  const auto& operands = condition.operands;
  if (condition.kind == ExprKind::Test && operands.size() == 1 && isConstant(operands[0]))
    return Expected{condition.name.text, operands[0].range};
  if (condition.kind == ExprKind::Equal && operands.size() == 2 &&
      operands[0].kind == ExprKind::Symbol && isConstant(operands[1]))
    return Expected{operands[0].name.text, operands[1].range};
  return std::nullopt;
}

/// Offers to add an effect to the outcome.
void offerEffect(Finding& finding, const Report& report, FileId file,
                 const syntax::Outcome& outcome, const std::string& effect) {
  const std::string& text = report.program.files[file].document.text();
  const std::string title = fmt::format("set `{}` when it ends", effect);
  const auto& items = outcome.effects.items;
  const syntax::Range old = outcome.effects.range;
  if (items.empty()) {
    const auto at = outcome.postconditionField->begin;
    finding.fix(title, {file, {at, at}}, fmt::format(":effects {} ", effect));
  } else if (items.size() == 1 && items[0].range == old) {
    finding.fix(title, {file, old},
                fmt::format("({} {})", text.substr(old.begin, old.length()), effect));
  } else {
    finding.fix(title, {file, {items.back().range.end, items.back().range.end}}, " " + effect);
  }
}

/// Offers to change the postcondition to match the outcome's effect, or to add the effect if there
/// is none. If that would be a forbidden move, there is no fix.
void offerEdit(Finding& finding, const Report& report, const Process& process,
               const Returned& returned, const syntax::Outcome& outcome) {
  const auto expected = expectedBy(*outcome.postcondition);
  if (!expected) return;
  const Location condition = report.system().at(process, outcome.postcondition->range);
  const std::string& text = report.program.files[condition.file].document.text();
  auto words = [&](syntax::Range range) { return text.substr(range.begin, range.length()); };
  const auto own = std::ranges::find(outcome.effects.items, expected->variable,
                                     [](const syntax::Effect& each) { return each.variable.text; });
  if (own != outcome.effects.items.end()) {
    const std::string right = words(own->range);
    if (expectedBy(
            {.kind = syntax::ExprKind::Test, .name = own->variable, .operands = {own->value}}))
      finding.fix(fmt::format("expect `{}`, which it sets", right), condition, right);
    return;
  }
  const auto id = report.system().resolver().stateVariable(expected->variable);
  const auto slot = id ? process.slots.find(*id) : std::nullopt;
  const auto number =
      id ? report.variables()[*id].domain.numberOf(words(expected->value)) : std::nullopt;
  if (!slot || !number || report.variables()[*id].domain.isNumeric()) return;
  const ValueSet to = report.variables()[*id].domain.saturated({*number, *number});
  bool allowed = true;
  for (const State& after : returned.after)
    forEach(after.values[*slot],
            [&](unsigned from) { allowed &= report.variables()[*id].forbidden(from, to).empty(); });
  if (allowed)
    offerEffect(finding, report, condition.file, outcome,
                fmt::format("({} {})", expected->variable, words(expected->value)));
}

} // namespace

void checkPostconditions(Report& report) {
  std::map<const syntax::Outcome*, Returned> outcomes;
  forEachReachedNode(
      report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
        if (each.kind != NodeKind::Outcome || !each.outcome || !each.outcome->postcondition) return;
        Returned& returned = outcomes[each.outcome];
        returned.process = id;
        for (const State& before : report.solver.cases(id, node))
          returned.after.push_back(report.solver.afterEffects(before, process, node));
      });
  for (const auto& [outcome, returned] : outcomes) {
    const Process& process = report.system()[returned.process];
    Condition condition =
        report.system().resolver().condition(*outcome->postcondition, process.slots);
    auto holds = [&](const State& after) { return mayHold(after, condition); };
    if (std::ranges::any_of(returned.after, holds)) continue;
    State all;
    for (const State& after : returned.after) all.join(after);
    Finding finding = report.findings.report(
        syntax::Code::PostconditionNeverHolds,
        report.system().at(process, outcome->postcondition->range), outcome->tag.text);
    addValues(finding, report, process, all, {condition});
    offerEdit(finding, report, process, returned, *outcome);
  }
}

} // namespace proskill::analysis::flow
