#pragma once

#include "verify/explore/explorer.h"
#include "verify/progress/progress_check.h"

namespace proskill::verify {

/// A move of a monitor along a run: together with a step, or at a date between two steps.
struct MonitorMove {
  std::size_t after = 0; ///< number of steps taken before it, including the step of the move
  std::size_t until = 0; ///< greatest number of steps taken before it, if it is between two steps
  bool atStep = false;
  bool atEnd = false;         ///< the run has ended; its last state is read again
  bool ticks = false;         ///< not a move: 1 time unit has passed since the last such mark
  std::uint32_t location = 0; ///< of the monitor, before the move
  std::uint32_t edge = 0;
};

/// A bound on the difference of two clocks, a - b. A clock that is kNone stands for 0.
struct ClockDifference {
  ClockId a = kNone;
  ClockId b = kNone;
  Bound limit = kInfinite;
};

/// The steps that reach a goal, and the bounds on clocks at their end where these matter.
struct Evidence {
  Steps steps;
  std::vector<ClockRange> clocks;
  std::vector<ClockDifference> differences{}; ///< more bounds on clocks at the end
  const Monitor* monitor = nullptr;           ///< the monitor that accepts the run by these moves
  std::vector<MonitorMove> marks;
  std::optional<std::size_t> loop; ///< the steps from this one on repeat for ever
  /// The run ends, and the monitor repeats its moves from this one on for ever.
  std::optional<std::size_t> rest;
};

/// Whether a run along the steps ends with the clocks in their ranges.
[[nodiscard]] bool isReal(const System& system, const Evidence& evidence, LimitWatch& limits);

struct SearchResult {
  std::vector<std::optional<Evidence>> goals; ///< by goal; nothing if it was not found
  Exploration statistics;
  bool paused = false;         ///< the search stopped early, as it was asked to
  bool limited = false;        ///< a limit ended it
  std::string progressStopped; ///< the limit because of which it is unknown whether time can stop
  std::optional<Unsupported> failure;
};

/// Adds the sizes of another exploration.
void addCounts(Exploration& to, const Exploration& more);

/// Adds the sizes, the time and the end of another exploration of the same system.
/// \param more the later exploration; its time includes the earlier one
void add(Exploration& to, const Exploration& more);

/// Receives the index of a goal and the evidence for it, as soon as it is found.
using OnEvidence = std::function<void(std::size_t, const Evidence&)>;

/// Searches for all goals in one exploration. A second exploration with finer zones follows if the
/// first one could not decide whether time can stop.
/// \param guide leads the search: to goals that are not about time
/// \param checkpoint keeps the state of the first exploration; see Explorer
[[nodiscard]] SearchResult search(const System& system, const std::vector<Goal>& goals,
                                  const Reductions& reductions, Extrapolation extrapolation,
                                  LimitWatch& limits, const OnEvidence& onFound,
                                  const Pause& pause = {}, Guide guide = {},
                                  Checkpoint* checkpoint = nullptr);

} // namespace proskill::verify
