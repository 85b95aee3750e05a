#include "runtime/executor/executor.h"

#include "runtime/executor/description.h"
#include "runtime/executor/stopwatch.h"

#include <algorithm>
#include <unistd.h>

namespace proskill::runtime {

using verify::TransitionId;

namespace {

class Executor {
public:
  Executor(const Executable& of, Clock& with, Platform& on, Observer& by, const RunOptions& given)
      : executable(of),
        clock(with),
        platform(on),
        observer(by),
        options(given),
        machine(of, given.seed),
        watch(of),
        properties(of.system, of.properties, of.unit),
        runs(of.actions.size()) {
    platform.addDescriptors(descriptors);
    if (options.stopDescriptor >= 0) descriptors.push_back(options.stopDescriptor);
  }

  RunResult run() {
    clock.start();
    properties.start(machine.state().data(), decided);
    while (!ended) step();
    result.date = date;
    goOn();
    closePlatform();
    result.missionStatus = missionStatus(executable, machine);
    result.verdicts = properties.verdicts();
    return std::move(result);
  }

private:
  struct Run {
    RunNumber number = 0;
    bool isRunning = false;
    bool isStopping = false;
    Nanoseconds stopBy = 0; ///< isStopping: the date by which the platform must have stopped it
  };

  /// Takes the next step: an urgent one, else the first that is due, else what the platform
  /// reports.
  void step() {
    if (stopRequests() > 0) return shutDown();
    if (options.pause && !options.pause->admits()) return clock.wait(std::nullopt, descriptors);
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
      tellHeldUp();
      return take(due->transition, date);
    }
    passTimeTo(std::min(now, options.until.value_or(now)));
    if (options.until && date >= *options.until) return end(End::Until);
    lag = 0;
    if (giveUpSlowStop()) return;
    if (platform.poll(date, report)) return handle();
    await(due);
  }

  void passTimeTo(Nanoseconds to) {
    if (to <= date) return;
    stepsAtOnce = 0;
    date = to;
    watch.tellOvershoots(date, [&](const Remark& remark) { tell(remark); });
    properties.wait(machine.state().data(), date, decided);
  }

  /// Reports that a run is late, because the machine was suspended or the process was stopped.
  void tellHeldUp() {
    const bool is = lag > kSecond;
    if (is && !std::exchange(isHeldUp, is))
      tell({.kind = RemarkKind::Note,
            .date = date,
            .text = "this process was suspended: steps are taken later than their dates"});
    isHeldUp = is;
  }

  /// Waits for the next due date, time limit or report.
  void await(const std::optional<Machine::Due>& due) {
    auto first = platform.next();
    const auto limit = [&](std::optional<Nanoseconds> other) {
      if (other && (!first || *other < *first)) first = other;
    };
    if (due) limit(due->date);
    limit(watch.nextOvershoot());
    limit(properties.nextDecision(machine.state().data()));
    limit(graceEnd());
    if (!first && !platform.mayReport()) return end(End::Stuck);
    limit(options.until);
    clock.wait(first, descriptors);
  }

  void take(TransitionId step, Nanoseconds at) {
    if (options.pause) options.pause->passed();
    const auto& handling = executable.handling[step];
    if (!machine.take(step, at)) {
      result.failure = machine.log().failure;
      return end(End::Failed);
    }
    ++result.steps;
    result.maxLag = std::max(result.maxLag, lag);
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

  /// Whether the last step only asks an action to stop.
  [[nodiscard]] bool asksToStop(std::uint32_t action) const {
    if (action == verify::kNone) return false;
    const auto& of = executable.actions[action];
    const auto to = machine.location(of.instance);
    return machine.locationBefore(of.instance) == of.run && to != of.run && to != of.idle;
  }

  /// Starts or stops the action of a basic skill after one of its steps.
  void follow(std::uint32_t action) {
    const auto& of = executable.actions[action];
    const auto from = machine.locationBefore(of.instance);
    const auto to = machine.location(of.instance);
    if (from == to) return;
    if (to == of.run) return startAction(action);
    if (to != of.idle) stopAction(action);
  }

  void startAction(std::uint32_t action) {
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

  void stopAction(std::uint32_t action) {
    auto& run = runs[action];
    watch.end(action);
    run.isStopping = true;
    run.stopBy = afterGrace();
    tell({.kind = RemarkKind::Asked, .date = date, .subject = nameOf(action)});
    if (platform.stop(action, run.number, date)) returned(action, kUnknownResult);
  }

  void handle() {
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
  void returned(std::uint32_t action, std::uint32_t result) {
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

  void signal(std::uint32_t index) {
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

  [[nodiscard]] bool missionIsOver() const {
    if (executable.mission == verify::kNone) return false;
    return machine.location(executable.mission) == executable.missionEnded &&
           std::ranges::none_of(runs, &Run::isRunning);
  }

  [[nodiscard]] int stopRequests() const {
    return options.stopRequests ? options.stopRequests->load(std::memory_order_relaxed) : 0;
  }

  /// Ends the run before the program does. Asks every running action to stop, the latest first, and
  /// waits for their ends.
  void shutDown() {
    goOn();
    const auto due = machine.due(); // is not taken any more: no run of the model is later
    passTimeTo(due ? std::min(due->date, clock.now()) : clock.now());
    tell({.kind = RemarkKind::Note, .date = date, .text = "asked to end: actions are stopped"});
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
    awaitStops(afterGrace());
    const bool all = std::ranges::none_of(runs, &Run::isRunning);
    for (std::uint32_t i = 0; i < runs.size(); ++i)
      if (runs[i].isRunning)
        tell({.kind = RemarkKind::Fault,
              .date = date,
              .subject = nameOf(i),
              .text = "its action did not stop in time, and may still be running"});
    end(all ? End::Stopped : End::Abandoned);
  }

  /// What happens at the end of a run takes time even if it is paused.
  void goOn() const {
    if (options.pause) options.pause->resume();
  }

  void awaitStops(Nanoseconds deadline) {
    while (std::ranges::any_of(runs, &Run::isRunning) && date < deadline && !isUrged())
      if (!hearLastWord()) wait(deadline);
  }

  void closePlatform() {
    platform.close();
    const auto deadline = afterGrace();
    while (!platform.isClosed() && date < deadline && !isUrged())
      if (!hearLastWord() && !platform.isClosed()) wait(deadline);
    while (platform.isClosed() && hearLastWord()) {
    }
    if (platform.isClosed() || result.end == End::Abandoned) return;
    tell({.kind = RemarkKind::Fault,
          .date = date,
          .text = "the platform's program did not end in time; it is killed"});
  }

  /// Processes a report after the program's last step.
  /// \return false if there is none
  bool hearLastWord() {
    date = std::max(clock.now(), date); // a platform may never stop reporting
    if (!platform.poll(date, report)) return false;
    if (report.kind == ReportKind::Fault || report.kind == ReportKind::Note) tellRun(report.kind);
    if (report.kind == ReportKind::Result && runs[report.action].number == report.run)
      runs[report.action].isRunning = false;
    return true;
  }

  void wait(Nanoseconds deadline) {
    clock.wait(std::min(deadline, platform.next().value_or(deadline)), descriptors);
    date = std::max(clock.now(), date);
  }

  /// Whether a second request to end has come. Reads the descriptor first; otherwise the first
  /// request would wake every wait.
  [[nodiscard]] bool isUrged() const {
    std::uint64_t times = 0;
    if (options.stopDescriptor >= 0)
      std::ignore = ::read(options.stopDescriptor, &times, sizeof times);
    return stopRequests() >= 2;
  }

  /// The end of a time that the platform gets from now on. The last step may be long ago.
  [[nodiscard]] Nanoseconds afterGrace() const {
    return std::max(clock.now(), date) + options.grace;
  }

  /// The first date by which the platform must have stopped an action.
  [[nodiscard]] std::optional<Nanoseconds> graceEnd() const {
    std::optional<Nanoseconds> first;
    for (const auto& run : runs)
      if (run.isRunning && run.isStopping && (!first || run.stopBy < *first)) first = run.stopBy;
    return first;
  }

  /// Ends a skill whose action does not stop in time, to free its resources and to wake those who
  /// wait for it.
  bool giveUpSlowStop() {
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

  void end(End how) {
    result.end = how;
    ended = true;
  }

  void tell(const Remark& remark) {
    if (isBad(remark.kind)) ++result.bad;
    observer.onRemark(remark);
  }

  void tellRun(ReportKind kind) {
    tell({.kind = kind == ReportKind::Note ? RemarkKind::Note : RemarkKind::Fault,
          .date = date,
          .text = report.text});
  }

  [[nodiscard]] std::string_view nameOf(std::uint32_t action) const {
    return executable.model.performed[action].skill;
  }

  const Executable& executable;
  Clock& clock;
  Platform& platform;
  Observer& observer;
  const RunOptions& options;
  Machine machine;
  Stopwatch watch;
  PropertyMonitors properties;
  const PropertyMonitors::Decided decided = [this](const auto& made) {
    tell(remarkOf(executable, made));
  };
  std::vector<Run> runs; ///< by action
  std::vector<int> descriptors;
  Report report;
  RunNumber lastRun = 0;
  Nanoseconds date = 0;
  Nanoseconds lag = 0;
  std::uint64_t stepsAtOnce = 0;
  bool isLost = false; ///< the platform has ended
  bool isHeldUp = false;
  bool ended = false;
  RunResult result;
};

} // namespace

RunResult execute(const Executable& executable, Clock& clock, Platform& platform,
                  Observer& observer, const RunOptions& options) {
  return Executor(executable, clock, platform, observer, options).run();
}

} // namespace proskill::runtime
