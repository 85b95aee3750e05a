#pragma once

#include "verify/state/enabled.h"
#include "verify/trace/clock_starts.h"

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace proskill::verify {

/// What chance prefers in a run.
struct Odds {
  std::vector<double> weights; ///< by transition, above 0 and at most 1
  double wait = 1; ///< mean time before a step of weight 1 that need not happen, in ticks
};

/// A moment of a run.
struct RunMoment {
  std::vector<Word> state;
  TransitionSet enabled;
  ClockStarts since; ///< dates instead of numbers of steps
  std::size_t now = 0;
};

/// A run of a system in which chance decides: each step that is possible draws a date within its
/// bounds, and the earliest happens. A step with an upper bound, or with a lower one, draws evenly;
/// the others wait for an exponential time. David, Larsen, Legay, Mikučionis, Poulsen, "Uppaal SMC
/// tutorial", STTT 17, 2015. Dates are counted in ticks of half a time unit, so that open bounds
/// can be kept.
class ChanceRun {
public:
  using Random = std::minstd_rand;

  static constexpr std::uint64_t kTicks = 2; ///< in a time unit

  /// \pre the arguments outlive this, and the system has no priorities
  ChanceRun(const System& of, const Enabling& with);

  /// Goes on from another moment.
  void goTo(const RunMoment& moment) { at = moment; }
  [[nodiscard]] const RunMoment& moment() const { return at; }

  /// Takes a step. Nothing if none is possible, or if the step fails: see failed().
  std::optional<TransitionId> step(const Odds& odds, Random& random);
  /// Takes a step as early as possible. \return whether it was possible; otherwise nothing changes
  bool takeEarly(TransitionId step);
  /// The state before the last step.
  [[nodiscard]] const Word* before() const { return previous.data(); }
  /// The events of the last step.
  [[nodiscard]] const std::vector<EventId>& events() const { return log.events; }
  /// The step because of which step() returned nothing, if it caused an error of the model.
  [[nodiscard]] std::optional<TransitionId> failed() const { return failure; }

private:
  struct Candidate {
    TransitionId step = 0;
    std::size_t date = 0;
    double weight = 0;
  };

  [[nodiscard]] RunMoment start() const;
  [[nodiscard]] std::size_t latest() const;
  [[nodiscard]] std::size_t earliest(const Transition& transition) const;
  void drawDates(const Odds& odds, Random& random);
  [[nodiscard]] std::size_t drawDate(const Transition& transition, double weight, std::size_t first,
                                     std::size_t last, const Odds& odds, Random& random) const;
  [[nodiscard]] std::size_t first(Random& random) const;
  [[nodiscard]] bool take(const Candidate& candidate);

  const System& system;
  const Enabling& enabling;
  RunMoment at;
  std::vector<Word> previous;
  TransitionSet enabledBefore;
  std::vector<Candidate> candidates;
  std::optional<TransitionId> failure;
  StepLog log;
};

} // namespace proskill::verify
