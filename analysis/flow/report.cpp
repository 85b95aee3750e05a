#include "analysis/flow/report.h"

#include <algorithm>
#include <fmt/format.h>

namespace proskill::analysis::flow {

Location definitionOf(const Report& report, VariableId id) {
  const Variable& variable = report.variables()[id];
  const Program& program = report.program;
  if (variable.kind == VariableKind::StateVariable) {
    const auto& definition = program.stateVariables.all[variable.definition];
    return definition.at(definition->name.range);
  }
  if (variable.kind == VariableKind::Used) {
    const auto& definition = program.resources.all[variable.definition];
    return definition.at(definition->name.range);
  }
  const auto& definition = program.skills.all[variable.definition];
  return definition.at(definition->name.range);
}

void collectSlots(const Condition& condition, std::set<Slot>& slots) {
  if (condition.kind == Condition::Kind::Member) slots.insert(condition.slot);
  slots.insert(condition.slots.begin(), condition.slots.end());
  for (const Condition& operand : condition.operands) collectSlots(operand, slots);
}

void blameSkill(Report& report, std::size_t skill) {
  for (VariableKind kind : {VariableKind::Status, VariableKind::Result})
    report.blamed.insert(report.variables().of(kind, skill));
}

bool isBlamed(const Report& report, const Process& process,
              const std::vector<Condition>& conditions) {
  std::set<Slot> slots;
  for (const Condition& condition : conditions) collectSlots(condition, slots);
  return std::ranges::any_of(
      slots, [&](Slot slot) { return report.blamed.contains(process.slots[slot]); });
}

void addValues(Finding& finding, Report& report, const Process& process, const State& state,
               const std::vector<Condition>& conditions) {
  std::set<Slot> slots;
  for (const Condition& condition : conditions) collectSlots(condition, slots);
  for (Slot slot : slots) {
    VariableId variable = process.slots[slot];
    report.told.insert(variable);
    finding.related(definitionOf(report, variable),
                    fmt::format("`{}` can only be {} there", report.variables().name(variable),
                                report.variables().words(variable, state.values[slot])));
  }
}

} // namespace proskill::analysis::flow
