#include "runtime/executor/description.h"

#include "verify/compile/watch.h"
#include "verify/state/evaluate.h"
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

/// A part of a message, in the state before the step that prints it.
std::string textOf(const Executable& executable, const Machine& machine, const MessagePart& part) {
  const auto read = [&](std::uint32_t watched) {
    const auto cell = executable.system.watched[watched].cell;
    return verify::readCell(executable.system, cell, machine.stateBefore().data());
  };
  if (part.terms.empty()) return part.text;
  if (part.isValue) {
    const auto watched = part.terms.front().watched;
    return verify::shown(executable.system.watched[watched], read(watched));
  }
  auto sum = part.constant;
  for (const auto& term : part.terms) sum += term.factor * read(term.watched);
  return std::to_string(sum);
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

std::optional<std::uint32_t> stoppingAction(const Executable& executable, const Machine& machine) {
  for (std::uint32_t i = 0; i < executable.actions.size(); ++i) {
    const auto& action = executable.actions[i];
    const auto to = machine.location(action.instance);
    if (machine.locationBefore(action.instance) == action.run && to != action.run &&
        to != action.idle)
      return i;
  }
  return std::nullopt;
}

std::vector<verify::Change> initialValues(const Executable& executable) {
  auto all = valuesIn(executable.system, verify::initialState(executable.system));
  all.resize(executable.shownVariables);
  return all;
}

std::string missionStatus(const Executable& executable, const Machine& machine) {
  for (const auto& watched : executable.system.watched)
    if (executable.mission != verify::kNone &&
        watched.display == executable.model.mainSkill + ".status")
      return verify::shown(
          watched, verify::readCell(executable.system, watched.cell, machine.state().data()));
  return "";
}

std::optional<std::string> printedMessage(const Executable& executable, const Machine& machine) {
  if (executable.messages.empty()) return std::nullopt;
  for (const auto origin : machine.log().origins) {
    const auto found = executable.messages.find(origin);
    if (found == executable.messages.end()) continue;
    std::string text;
    for (const auto& part : found->second) text += textOf(executable, machine, part);
    return text;
  }
  return std::nullopt;
}

Remark remarkOf(const Executable& executable, const PropertyMonitors::Decision& decision) {
  const auto& check = executable.model.checks[executable.properties[decision.property].check];
  return {.kind = decision.verdict == Verdict::True ? RemarkKind::Holds : RemarkKind::Violated,
          .date = decision.date,
          .subject = check.name,
          .text = check.description,
          .origin = check.origin};
}

Remark alarmOf(const Executable& executable, fiacre::OriginId origin, Nanoseconds date) {
  const auto& of = executable.model.provenance.origins[origin];
  const bool isGuard = executable.model.alarms.at(origin) == codegen::Alarm::FailedInvariant;
  return {.kind = isGuard ? RemarkKind::GuardFailed : RemarkKind::Alarm,
          .date = date,
          .subject = of.actor,
          .text = of.description,
          .origin = origin};
}

const char* whyIgnored(const codegen::Model& model, const codegen::Signal& signal) {
  if (signal.interrupts) return "there is nothing to interrupt";
  return model.hasEnvironment ? "ignored: the program's environment generates this event"
                              : "ignored: the `:guard` of this event does not hold";
}

std::string commandText(const codegen::ActionCall* call, std::string_view skill) {
  if (!call) return std::string(skill);
  std::string text = "(" + call->command;
  for (const auto& argument : call->arguments) text += " " + (argument.empty() ? "?" : argument);
  return text + ")";
}

} // namespace proskill::runtime
