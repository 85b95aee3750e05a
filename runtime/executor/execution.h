#pragma once

#include "runtime/clock/clock.h"
#include "runtime/executor/observer.h"
#include "runtime/executor/run_options.h"
#include "runtime/executor/stopwatch.h"

namespace proskill::runtime {

enum class Progress : std::uint8_t {
  Moved, ///< something has happened, and more may be possible at once
  Waits, ///< nothing happens before `wakeDate`, or before a descriptor is readable
  Ended,
};

/// A run of a program that never waits: its owner does, between two calls of `proceed`.
class Execution {
public:
  /// \pre what is referred to outlives this
  Execution(const Executable& executable, Clock& clock, Platform& platform, Observer& observer,
            const RunOptions& options);
  Execution(const Execution&) = delete;
  Execution& operator=(const Execution&) = delete;

  /// Starts the clock.
  void start();
  /// Does what comes next, if it can be done now. \pre the run was started
  [[nodiscard]] Progress proceed();
  /// nullopt: no time limit. \pre the run waits
  [[nodiscard]] std::optional<Nanoseconds> wakeDate() const { return wake; }
  /// Is readable when the platform has a report, or when the run was asked to end.
  [[nodiscard]] const std::vector<int>& descriptors() const { return watched; }

  [[nodiscard]] const Machine& state() const { return machine; }
  [[nodiscard]] Nanoseconds now() const { return date; }
  /// The steps and faults so far; the rest is set at the end of the run.
  [[nodiscard]] const RunResult& result() const { return outcome; }
  /// Whether the run takes no more steps.
  [[nodiscard]] bool isEnding() const { return phase != Phase::Steps; }

private:
  enum class Phase : std::uint8_t {
    Steps, ///< of the program
    Stops, ///< running actions are asked to stop
    Close, ///< the platform closes
    Ended,
  };
  struct Run {
    RunNumber number = 0;
    bool isRunning = false;
    bool isStopping = false;
    Nanoseconds stopBy = 0; ///< isStopping: the date by which the platform must have stopped it
  };

  // Steps
  void step();
  void passTimeTo(Nanoseconds to);
  [[nodiscard]] std::optional<Nanoseconds> nextJudgement();
  void judgeUntil(Nanoseconds until);
  void tellHeldUp(Nanoseconds late);
  void await(const std::optional<Machine::Due>& due);
  void take(verify::TransitionId step, Nanoseconds at);
  [[nodiscard]] bool missionIsOver() const;

  // Actions and reports
  [[nodiscard]] bool asksToStop(std::uint32_t action) const;
  void follow(std::uint32_t action);
  void startAction(std::uint32_t action);
  void stopAction(std::uint32_t action);
  void handle();
  void returned(std::uint32_t action, std::uint32_t result);
  void signal(std::uint32_t index);
  [[nodiscard]] std::optional<Nanoseconds> graceEnd() const;
  bool giveUpSlowStop();

  // The end
  [[nodiscard]] int stopRequests() const;
  void shutDown();
  void stopAll();
  void awaitStops();
  void beginClose();
  void awaitClose();
  void goOn() const;
  [[nodiscard]] bool isUrged() const;
  bool hearLastWord();
  void end(End how);

  // Time and remarks
  void waitUntil(std::optional<Nanoseconds> until);
  void waitForPlatform();
  void catchUp();
  [[nodiscard]] Nanoseconds after(Nanoseconds grace) const;
  void tell(const Remark& remark);
  void tellRun(ReportKind kind);
  [[nodiscard]] std::string_view nameOf(std::uint32_t action) const;

  const Executable& executable;
  Clock& clock;
  Platform& platform;
  Observer& observer;
  const RunOptions options;
  Machine machine;
  Stopwatch watch;
  PropertyMonitors properties;
  const PropertyMonitors::Decided decided;
  std::vector<Run> runs; ///< by action
  std::vector<int> watched;
  Report report;
  RunNumber lastRun = 0;
  Phase phase = Phase::Steps;
  bool isWaiting = false; ///< after `proceed`
  bool hasWaited = false; ///< for the platform
  std::optional<Nanoseconds> wake;
  std::optional<Nanoseconds> expected; ///< when the last wait should have ended at the latest
  Nanoseconds date = 0;
  Nanoseconds lag = 0;
  Nanoseconds deadline = 0; ///< Stops, Close: the platform has time until then
  std::uint64_t stepsAtOnce = 0;
  bool isLost = false; ///< the platform has ended
  bool isHeldUp = false;
  bool isClosing = false; ///< the platform was asked to close
  RunResult outcome;
};

} // namespace proskill::runtime
