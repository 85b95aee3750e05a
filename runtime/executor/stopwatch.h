#pragma once

#include "runtime/executor/observer.h"

namespace proskill::runtime {

/// Measures the duration of actions and of composite skills, and the time between reported events.
class Stopwatch {
public:
  explicit Stopwatch(const Executable& of);

  void start(std::uint32_t action, Nanoseconds date);
  /// An action has ended by itself: reports whether it took too little or too much time.
  template <class Tell> void finish(std::uint32_t action, Nanoseconds date, Tell&& tell) {
    finish(actions[action], ofAction(action), date, tell);
  }
  /// Stops measuring an action.
  void end(std::uint32_t action) { actions[action].isRunning = false; }

  /// Starts or ends the measurement of a composite skill, depending on the machine's last step.
  template <class Tell>
  void follow(std::uint32_t stretch, const Machine& machine, Nanoseconds date, Tell&& tell) {
    const bool ran = runs(stretch, machine.locationBefore(executable.stretches[stretch].instance));
    const bool isRunning = runs(stretch, machine.location(executable.stretches[stretch].instance));
    if (!ran && isRunning) stretches[stretch] = {.isRunning = true, .begin = date};
    if (ran && !isRunning) finish(stretches[stretch], ofStretch(stretch), date, tell);
  }

  /// The first date at which something takes too long.
  [[nodiscard]] std::optional<Nanoseconds> nextOvershoot() const;
  /// An event was reported: checks the time since the last one, and measures until the next one.
  template <class Tell> void occur(std::uint32_t signal, Nanoseconds date, Tell&& tell) {
    if (!events[signal].isRunning) return;
    finish(events[signal], ofEvent(signal), date, tell);
    events[signal] = {.isRunning = true, .begin = date};
  }
  template <class Tell> void tellOvershoots(Nanoseconds date, Tell&& tell) {
    for (std::uint32_t i = 0; i < actions.size(); ++i)
      tellOvershoot(actions[i], ofAction(i), date, tell);
    for (std::uint32_t i = 0; i < stretches.size(); ++i)
      tellOvershoot(stretches[i], ofStretch(i), date, tell);
    for (std::uint32_t i = 0; i < events.size(); ++i)
      tellOvershoot(events[i], ofEvent(i), date, tell);
  }

private:
  struct Measure {
    bool isRunning = false;
    bool isLate = false; ///< and this was reported
    Nanoseconds begin = 0;
  };
  struct Subject {
    std::string_view name;
    const Span& span;
    fiacre::OriginId origin = 0;
    std::string_view early = "took less time than its interval says";
    std::string_view late = "takes more time than its interval says";
  };

  [[nodiscard]] Subject ofAction(std::uint32_t action) const;
  [[nodiscard]] Subject ofStretch(std::uint32_t stretch) const;
  [[nodiscard]] Subject ofEvent(std::uint32_t signal) const;
  [[nodiscard]] bool runs(std::uint32_t stretch, std::int64_t location) const {
    const auto& of = executable.stretches[stretch];
    return location != of.idle && location != of.ended;
  }

  template <class Tell>
  static void finish(Measure& measure, const Subject& subject, Nanoseconds date, Tell&& tell) {
    if (!measure.isRunning) return;
    tellOvershoot(measure, subject, date, tell);
    measure.isRunning = false;
    if (date - measure.begin >= subject.span.first) return;
    tell(Remark{.kind = RemarkKind::Undershoot,
                .date = date,
                .subject = subject.name,
                .text = subject.early,
                .origin = subject.origin});
  }

  template <class Tell>
  static void tellOvershoot(Measure& measure, const Subject& subject, Nanoseconds date,
                            Tell&& tell) {
    const auto& last = subject.span.last;
    if (!measure.isRunning || measure.isLate || !last || date - measure.begin <= *last) return;
    measure.isLate = true;
    tell(Remark{.kind = RemarkKind::Overshoot,
                .date = date,
                .subject = subject.name,
                .text = subject.late,
                .origin = subject.origin});
  }

  const Executable& executable;
  std::vector<Measure> actions;
  std::vector<Measure> stretches;
  std::vector<Measure> events; ///< by signal
};

} // namespace proskill::runtime
