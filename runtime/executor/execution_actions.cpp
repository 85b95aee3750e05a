#include "runtime/executor/execution.h"

#include "runtime/executor/description.h"

#include <algorithm>

namespace proskill::runtime {

/// Whether the last step only asks an action to stop.
bool Execution::asksToStop(std::uint32_t action) const {
  if (action == verify::kNone) return false;
  const auto& of = executable.actions[action];
  const auto to = machine.location(of.instance);
  return machine.locationBefore(of.instance) == of.run && to != of.run && to != of.idle;
}

/// Starts or stops the action of a basic skill after one of its steps.
void Execution::follow(std::uint32_t action) {
  const auto& of = executable.actions[action];
  const auto from = machine.locationBefore(of.instance);
  const auto to = machine.location(of.instance);
  if (from == to) return;
  if (to == of.run) return startAction(action);
  if (to != of.idle) stopAction(action);
}

void Execution::startAction(std::uint32_t action) {
  if (isLost) {
    tell({.kind = RemarkKind::Fault,
          .date = date,
          .subject = nameOf(action),
          .text = "its action cannot start: the platform has ended"});
    return end(End::Lost);
  }
  auto& run = runs[action];
  run = {.number = ++lastRun, .isRunning = true};
  watch.start(action, date);
  const Start start{action, run.number, executable.callOf(action, machine.state().data())};
  tell({.kind = RemarkKind::Started, .date = date, .subject = nameOf(action), .start = &start});
  platform.start(start, date);
}

void Execution::stopAction(std::uint32_t action) {
  auto& run = runs[action];
  watch.end(action);
  run.isStopping = true;
  run.stopBy = after(options.grace);
  tell({.kind = RemarkKind::Asked, .date = date, .subject = nameOf(action)});
  if (platform.stop(action, run.number, date)) returned(action, kUnknownResult);
}

void Execution::handle() {
  switch (report.kind) {
  case ReportKind::Signal: return signal(report.signal);
  case ReportKind::Fault:
  case ReportKind::Note: return tellRun(report.kind);
  case ReportKind::Lost: isLost = true; return;
  case ReportKind::Result: break;
  }
  const auto& run = runs[report.action];
  if (!run.isRunning || run.number != report.run)
    return tell({.kind = RemarkKind::Fault,
                 .date = date,
                 .subject = nameOf(report.action),
                 .text = report.text.empty() ? "ignored a result of a run that has already ended"
                                             : std::string_view(report.text)});
  if (!report.text.empty())
    tell({.kind = RemarkKind::Fault,
          .date = date,
          .subject = nameOf(report.action),
          .text = report.text});
  returned(report.action, report.result);
}

/// Ends an action: its skill gets the result, or the outcome of its interruption.
void Execution::returned(std::uint32_t action, std::uint32_t result) {
  auto& run = runs[action];
  const auto& of = executable.actions[action];
  run.isRunning = false;
  auto port = of.stoppedPort;
  if (!run.isStopping) {
    watch.finish(action, date, [&](const Remark& remark) { tell(remark); });
    port = result < of.resultPorts.size() ? of.resultPorts[result] : of.unknownPort;
  }
  run.isStopping = false;
  if (const auto step = machine.at(port)) take(*step, date);
}

void Execution::signal(std::uint32_t index) {
  const auto& of = executable.model.signals[index];
  if (const auto step = machine.at(executable.signalPorts[index])) {
    watch.occur(index, date, [&](const Remark& remark) { tell(remark); });
    return take(*step, date);
  }
  tell({.kind = RemarkKind::Note,
        .date = date,
        .subject = of.name,
        .text = whyIgnored(executable.model, of)});
}

/// The first date by which the platform must have stopped an action.
std::optional<Nanoseconds> Execution::graceEnd() const {
  std::optional<Nanoseconds> first;
  for (const auto& run : runs)
    if (run.isRunning && run.isStopping && (!first || run.stopBy < *first)) first = run.stopBy;
  return first;
}

/// Ends a skill whose action does not stop in time, to free its resources and to wake those who
/// wait for it.
bool Execution::giveUpSlowStop() {
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    auto& run = runs[i];
    if (!run.isRunning || !run.isStopping || run.stopBy > date) continue;
    tell({.kind = RemarkKind::Fault,
          .date = date,
          .subject = nameOf(i),
          .text = "its action does not stop; its skill ends without it"});
    platform.abandon(i, run.number, date);
    returned(i, kUnknownResult);
    return true;
  }
  return false;
}

} // namespace proskill::runtime
