#include "runtime/executor/execution.h"

#include "runtime/executor/description.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <unistd.h>
#include <utility>

namespace proskill::runtime {

int Execution::stopRequests() const {
  return options.stopRequests ? options.stopRequests->load(std::memory_order_relaxed) : 0;
}

/// Ends the run before the program does. Asks every running action to stop, the latest first, and
/// gives them time for that.
void Execution::shutDown() {
  goOn();
  const auto due = machine.due(); // is not taken any more: no run of the model is later
  passTimeTo(due ? std::min(due->date, clock.now()) : clock.now());
  tell({.kind = RemarkKind::Note, .date = date, .text = "asked to end: actions are stopped"});
  stopAll();
  deadline = after(options.endGrace.value_or(options.grace));
  phase = Phase::Stops;
}

void Execution::stopAll() {
  std::vector<std::uint32_t> running;
  for (std::uint32_t i = 0; i < runs.size(); ++i)
    if (runs[i].isRunning) running.push_back(i);
  std::ranges::sort(running, std::greater{}, [&](auto i) { return runs[i].number; });
  for (const auto action : running) {
    if (runs[action].isStopping) continue;
    tell({.kind = RemarkKind::Asked, .date = date, .subject = nameOf(action)});
    runs[action].isStopping = true;
    if (platform.stop(action, runs[action].number, date)) runs[action].isRunning = false;
  }
}

void Execution::awaitStops() {
  catchUp();
  const bool all = std::ranges::none_of(runs, &Run::isRunning);
  if (!all && date < deadline && !isUrged()) {
    if (!hearLastWord()) waitForPlatform();
    return;
  }
  for (std::uint32_t i = 0; i < runs.size(); ++i)
    if (runs[i].isRunning)
      tell({.kind = RemarkKind::Fault,
            .date = date,
            .subject = nameOf(i),
            .text = "its action did not stop in time, and may still be running"});
  end(all ? End::Stopped : End::Abandoned);
}

void Execution::beginClose() {
  outcome.date = date;
  goOn();
  platform.close();
  deadline = after(options.endGrace.value_or(options.grace));
  isClosing = true;
}

void Execution::awaitClose() {
  catchUp();
  if (!platform.isClosed() && date < deadline && !isUrged()) {
    if (!hearLastWord() && !platform.isClosed()) waitForPlatform();
    return;
  }
  while (platform.isClosed() && hearLastWord()) {
  }
  if (!platform.isClosed() && outcome.end != End::Abandoned)
    tell({.kind = RemarkKind::Fault,
          .date = date,
          .text = "the platform's program did not end in time; it is killed"});
  outcome.missionStatus = missionStatus(executable, machine);
  outcome.verdicts = properties.verdicts();
  phase = Phase::Ended;
}

/// What happens at the end of a run takes time even if it is paused.
void Execution::goOn() const {
  if (options.pause) options.pause->resume();
}

/// Whether a second request to end has come. Reads the descriptor first; otherwise the first
/// request would wake every wait.
bool Execution::isUrged() const {
  std::uint64_t times = 0;
  if (options.stopDescriptor >= 0)
    std::ignore = ::read(options.stopDescriptor, &times, sizeof times);
  return stopRequests() >= 2;
}

/// Processes a report after the program's last step.
/// \return false if there is none
bool Execution::hearLastWord() {
  date = std::max(clock.now(), date); // a platform may never stop reporting
  if (!platform.poll(date, report)) return false;
  if (report.kind == ReportKind::Fault || report.kind == ReportKind::Note) tellRun(report.kind);
  if (report.kind == ReportKind::Result && runs[report.action].number == report.run)
    runs[report.action].isRunning = false;
  return true;
}

void Execution::waitForPlatform() {
  waitUntil(std::min(deadline, platform.next().value_or(deadline)));
  hasWaited = true;
}

/// After a wait for the platform, the run's time is that of the clock.
void Execution::catchUp() {
  if (std::exchange(hasWaited, false)) date = std::max(clock.now(), date);
}

/// The end of a time that the platform gets from now on. The last step may be long ago.
Nanoseconds Execution::after(Nanoseconds grace) const {
  return std::max(clock.now(), date) + grace;
}

void Execution::end(End how) {
  outcome.end = how;
  phase = Phase::Close;
}

} // namespace proskill::runtime
