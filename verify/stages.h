#pragma once

#include "verify/explore/explorer.h"
#include "verify/refine/refinement.h"

#include <vector>

namespace proskill::verify {

/// Limit of questions times transitions; beyond it, determining the slices takes seconds.
inline constexpr std::size_t kMostWork = 20'000'000;
/// The same limit for led searches, each of which prepares the whole system.
inline constexpr std::size_t kMostLedWork = 100'000;

/// What is tried when a search of the whole system has reached a size.
struct Stage {
  SearchSize at;
  SearchSize slices{0, 0};    ///< of the searches of all slices together
  Refinement::Budget refined; ///< of slices that are refined
  std::uint64_t sampled = 0;  ///< steps of random runs without a result, after which they end
  bool samplesTraces = false; ///< also for questions whose traces are wanted
  std::uint64_t newest = 0;   ///< classes of a search that begins with new states
  std::uint64_t led = 0;      ///< classes of all led searches together
  std::uint64_t ledEach = 0;  ///< a led search of fewer classes is not worth its preparation
  std::uint64_t walks = 0;    ///< classes of a search by random walks
};

/// Small slices, random runs and short led searches come early, since these cost little.
/// docs/benchmarks.md has the measurements from which the numbers come.
[[nodiscard]] std::vector<Stage> stagesOf(const Options& options);

} // namespace proskill::verify
