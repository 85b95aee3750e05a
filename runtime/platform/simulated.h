#pragma once

#include "runtime/machine/random.h"
#include "runtime/platform/platform.h"

#include <memory>

namespace proskill::runtime {

/// Behaviour of a simulated platform, as far as the program does not define it.
struct SimulationSettings {
  struct OfAction {
    Span duration;                 ///< from `:time_interval`
    Span stops;                    ///< time that it takes to stop
    std::vector<unsigned> weights; ///< of its results: relative frequencies
  };
  struct Ending {
    std::optional<Nanoseconds> after; ///< nullopt: drawn
    std::optional<std::uint32_t> result;
  };
  struct Said {
    Nanoseconds date = 0;
    std::uint32_t signal = 0;
  };
  std::vector<OfAction> actions;
  std::vector<std::vector<Ending>> endings; ///< by action: of its first runs
  std::vector<std::optional<Span>> signals; ///< time since the last one; nullopt: never
  std::vector<Said> script;                 ///< by date
};

/// Actions take a time from their intervals, or up to 10 s more than the least; successes are more
/// likely than failures. Events come as their `:every` says, else every 5 to 60 s if the program
/// has no environment of its own. Nothing is interrupted.
[[nodiscard]] SimulationSettings defaultSettings(const Executable& executable);

[[nodiscard]] std::unique_ptr<Platform> simulatedPlatform(SimulationSettings settings,
                                                          std::uint64_t seed);

} // namespace proskill::runtime
