#include "runtime/executor/execution.h"

#include "runtime/executor/description.h"

#include <algorithm>
#include <utility>

namespace proskill::runtime {

using verify::TransitionId;

Execution::Execution(const Executable& of, Clock& with, Platform& on, Observer& by,
                     const RunOptions& given)
    : executable(of),
      clock(with),
      platform(on),
      observer(by),
      options(given),
      machine(of, given.seed),
      watch(of),
      properties(of.system, of.properties, of.unit),
      decided([this](const auto& made) { tell(remarkOf(executable, made)); }),
      runs(of.actions.size()) {
  platform.addDescriptors(watched);
  if (options.stopDescriptor >= 0) watched.push_back(options.stopDescriptor);
}

void Execution::start() {
  clock.start();
  properties.start(machine.state().data(), decided);
}

Progress Execution::proceed() {
  isWaiting = false;
  switch (phase) {
  case Phase::Steps: step(); break;
  case Phase::Stops: awaitStops(); break;
  case Phase::Close: isClosing ? awaitClose() : beginClose(); break;
  case Phase::Ended: break;
  }
  if (phase == Phase::Ended) return Progress::Ended;
  return isWaiting ? Progress::Waits : Progress::Moved;
}

/// Asks the owner to wait.
void Execution::waitUntil(std::optional<Nanoseconds> until) {
  wake = until;
  isWaiting = true;
}

/// Takes the next step: an urgent one, else the first that is due, else what the platform
/// reports.
void Execution::step() {
  if (stopRequests() > 0) return shutDown();
  if (options.pause && !options.pause->admits()) return waitUntil(std::nullopt);
  if (const auto urgent = machine.urgent()) {
    if (++stepsAtOnce > options.mostAtOnce) return end(End::NoTime);
    return take(*urgent, date);
  }
  if (missionIsOver()) return end(End::Mission);
  const auto now = clock.now();
  const auto due = machine.due();
  if (due && due->date <= std::min(now, options.until.value_or(now))) {
    passTimeTo(due->date);
    lag = now - date;
    tellHeldUp(lag);
    return take(due->transition, date);
  }
  if (expected) tellHeldUp(now - *std::exchange(expected, std::nullopt));
  passTimeTo(std::min(now, options.until.value_or(now)));
  if (options.until && date >= *options.until) return end(End::Until);
  lag = 0;
  if (giveUpSlowStop()) return;
  if (platform.poll(date, report)) return handle();
  await(due);
}

void Execution::passTimeTo(Nanoseconds to) {
  if (to <= date) return;
  stepsAtOnce = 0;
  for (auto next = nextJudgement(); next && *next > date && *next < to; next = nextJudgement())
    judgeUntil(*next);
  judgeUntil(to);
}

/// The first date at which something takes too long, or at which a property is decided.
std::optional<Nanoseconds> Execution::nextJudgement() {
  const auto overshoot = watch.nextOvershoot();
  const auto decision = properties.nextDecision(machine.state().data());
  return overshoot && decision ? std::min(overshoot, decision) : overshoot ? overshoot : decision;
}

void Execution::judgeUntil(Nanoseconds until) {
  date = until;
  watch.tellOvershoots(date, [&](const Remark& remark) { tell(remark); });
  properties.wait(machine.state().data(), date, decided);
}

/// Reports that a run is late, because the machine was suspended or the process was stopped.
void Execution::tellHeldUp(Nanoseconds late) {
  const bool is = late > kSecond;
  if (is && !std::exchange(isHeldUp, is))
    tell({.kind = RemarkKind::Note,
          .date = date,
          .text =
              "this process was suspended: steps are taken later than their dates, and what the "
              "platform has reported is dated later"});
  isHeldUp = is;
}

/// Waits for the next due date, time limit or report.
void Execution::await(const std::optional<Machine::Due>& due) {
  auto first = platform.next();
  const auto limit = [&](std::optional<Nanoseconds> other) {
    if (other && (!first || *other < *first)) first = other;
  };
  if (due) limit(due->date);
  limit(nextJudgement());
  limit(graceEnd());
  if (!first && !platform.mayReport()) return end(End::Stuck);
  limit(options.until);
  if (first) expected = std::max(*first, date);
  waitUntil(first);
}

void Execution::take(TransitionId step, Nanoseconds at) {
  if (options.pause) options.pause->passed();
  const auto& handling = executable.handling[step];
  if (!machine.take(step, at)) {
    outcome.failure = machine.log().failure;
    return end(End::Failed);
  }
  ++outcome.steps;
  outcome.maxLag = std::max(outcome.maxLag, lag);
  observer.onStep(machine, step, at, lag);
  for (const auto origin : machine.log().origins)
    if (executable.isAlarm[origin]) tell(alarmOf(executable, origin, date));
  properties.step({.before = machine.stateBefore().data(),
                   .after = machine.state().data(),
                   .events = machine.log().events,
                   .date = at,
                   .asksToStop = asksToStop(handling.action)},
                  decided);
  if (handling.stretch != verify::kNone)
    watch.follow(handling.stretch, machine, at, [&](const Remark& remark) { tell(remark); });
  if (handling.action != verify::kNone) follow(handling.action);
}

bool Execution::missionIsOver() const {
  if (executable.mission == verify::kNone) return false;
  return machine.location(executable.mission) == executable.missionEnded &&
         std::ranges::none_of(runs, &Run::isRunning);
}

void Execution::tell(const Remark& remark) {
  if (isBad(remark.kind)) ++outcome.bad;
  observer.onRemark(remark);
}

void Execution::tellRun(ReportKind kind) {
  tell({.kind = kind == ReportKind::Note ? RemarkKind::Note : RemarkKind::Fault,
        .date = date,
        .text = report.text});
}

std::string_view Execution::nameOf(std::uint32_t action) const {
  return executable.model.performed[action].skill;
}

} // namespace proskill::runtime
