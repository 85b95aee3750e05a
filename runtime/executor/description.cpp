#include "runtime/executor/description.h"

#include "verify/state/state_layout.h"
#include "verify/trace/step_description.h"

#include <numeric>

namespace proskill::runtime {

namespace {

std::vector<std::uint32_t> shownVariables(const Executable& executable) {
  std::vector<std::uint32_t> all(executable.shownVariables);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

} // namespace

verify::Step lastStep(const Executable& executable, const Machine& machine,
                      verify::TransitionId step) {
  const auto& system = executable.system;
  return {.origins = mostDescriptiveLast(executable.model.provenance, machine.log()),
          .transitions = {nameOf(system, step, machine.log())},
          .instances = instancesOf(system, step),
          .changes = changesBetween(system, shownVariables(executable), machine.stateBefore(),
                                    machine.state())};
}

std::string stoppingSkill(const Executable& executable, const Machine& machine) {
  for (std::size_t i = 0; i < executable.actions.size(); ++i) {
    const auto& action = executable.actions[i];
    const auto to = machine.location(action.instance);
    if (machine.locationBefore(action.instance) == action.run && to != action.run &&
        to != action.idle)
      return executable.model.performed[i].skill;
  }
  return "";
}

std::vector<verify::Change> initialValues(const Executable& executable) {
  auto all = valuesIn(executable.system, verify::initialState(executable.system));
  all.resize(executable.shownVariables);
  return all;
}

std::string commandText(const codegen::ActionCall* call, std::string_view skill) {
  if (!call) return std::string(skill);
  std::string text = "(" + call->command;
  for (const auto& argument : call->arguments) text += " " + (argument.empty() ? "?" : argument);
  return text + ")";
}

} // namespace proskill::runtime
