#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

/// Finds values that a state variable never has, moves that are never made, and values that are
/// never left.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

/// The values that effects set, including unreachable effects, which are reported at their places.
std::vector<ValueSet> writtenAnywhere(const Report& report) {
  std::vector<ValueSet> written(report.variables().size());
  for (const Process& process : report.system().all())
    for (const Action& action : process.actions)
      for (const Assignment& each : action.assignments)
        if (each.value.kind == Term::Kind::Number)
          written[each.variable] |= report.variables()[each.variable].domain.saturated(
              {each.value.number, each.value.number});
  return written;
}

class Values {
public:
  Values(Report& report, std::size_t definition, const std::vector<ValueSet>& written)
      : report(report),
        definition(report.program.stateVariables.all[definition]),
        id(report.variables().of(VariableKind::StateVariable, definition)),
        variable(report.variables()[id]),
        set(written[id]) {}

  void check() {
    if (variable.domain.isNumeric() || isMerged() || report.told.contains(id)) return;
    if (isFrozen()) return;
    for (const syntax::Name& state : definition->states) {
      auto value = valueOf(state);
      if (!value || (set | report.solver.ever(id)).contains(*value)) continue;
      report.findings.report(Code::ValueNeverSet, definition.at(state.range), state.text,
                             definition.name());
    }
    checkTransitions();
  }

private:
  /// The values of a very large enumeration share classes.
  [[nodiscard]] bool isMerged() const {
    return variable.domain.size() < variable.domain.allWords().size();
  }

  [[nodiscard]] std::optional<unsigned> valueOf(const syntax::Name& name) const {
    auto number = variable.domain.numberOf(name.text);
    if (!number) return std::nullopt;
    return static_cast<unsigned>(*number);
  }

  void checkTransitions() {
    for (const syntax::Transition& move : definition->transitions) {
      auto from = valueOf(move.from);
      auto to = valueOf(move.to);
      if (!from || !to || from == to) continue;
      if (!report.solver.ever(id).contains(*from) || !report.solver.ever(id).contains(*to))
        continue;
      if (report.solver.mayMove(id, *from).contains(*to)) continue;
      report.findings.report(Code::TransitionNeverMade, definition.at(move.range),
                             definition.name(), move.from.text, move.to.text);
    }
  }

  /// Whether a value is never left, probably by accident. A value that is entered but never left is
  /// probably intended as final; the initial value, or one that is neither, is not.
  bool isFrozen() {
    if (variable.allowed.empty()) return false;
    for (const syntax::Name& state : definition->states) {
      auto value = valueOf(state);
      if (!value || variable.allowed[*value] != ValueSet::of(*value)) continue;
      bool entered = false;
      for (unsigned other = 0; other < variable.domain.size(); ++other)
        entered |= other != *value && variable.allowed[other].contains(*value);
      if (entered && !variable.initial.contains(*value)) continue;
      report.findings.report(Code::ValueNeverLeft, definition.at(state.range), definition.name(),
                             state.text);
      return true;
    }
    return false;
  }

  Report& report;
  const Definition<syntax::StateVariable>& definition;
  VariableId id;
  const Variable& variable;
  ValueSet set;
};

} // namespace

void checkValues(Report& report) {
  const std::vector<ValueSet> written = writtenAnywhere(report);
  for (std::size_t i = 0; i < report.program.stateVariables.all.size(); ++i)
    Values(report, i, written).check();
}

} // namespace proskill::analysis::flow
