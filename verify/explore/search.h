#pragma once

#include "verify/explore/explorer.h"
#include "verify/explore/progress_check.h"

namespace proskill::verify {

/// A move of a monitor along the steps: with a step, or at a date between two.
struct MonitorMove {
  std::size_t after = 0; ///< how many steps were taken, that of the move included
  std::size_t until = 0; ///< how many may have been taken, at most, when it comes between two
  bool atStep = false;
  bool atEnd = false;         ///< the run has ended; its last state is read again
  bool ticks = false;         ///< no move: time has gone on by 1 since the last mark of this kind
  std::uint32_t location = 0; ///< of the monitor, before
  std::uint32_t edge = 0;
};

/// A way to what a goal asks for, and where the clocks stand at its end where that matters.
struct Evidence {
  Steps steps;
  std::vector<ClockRange> clocks;
  const Monitor* monitor = nullptr; ///< that accepts the run, by these moves
  std::vector<MonitorMove> marks;
  std::optional<std::size_t> loop; ///< the steps from this one on are repeated for ever
  /// The run ends, and the monitor repeats its moves from this one on for ever.
  std::optional<std::size_t> rest;
};

struct SearchResult {
  std::vector<std::optional<Evidence>> goals; ///< by goal: nothing where nothing was found
  Exploration statistics;
  std::string progressStopped; ///< the limit that left open whether time can stop
  std::optional<Unsupported> failure;
};

/// Counts one more exploration of the same system. \param more the later one: its time is of both
void add(Exploration& to, const Exploration& more);

/// Gets a goal, by its place, and what was found of it, as soon as it is.
using OnEvidence = std::function<void(std::size_t, const Evidence&)>;

/// Looks for all goals: one exploration, and one more, with finer zones, where the first could not
/// tell whether time can stop.
[[nodiscard]] SearchResult search(const System& system, const std::vector<Goal>& goals,
                                  const Reductions& reductions, Extrapolation extrapolation,
                                  LimitWatch& limits, const OnEvidence& onFound);

} // namespace proskill::verify
