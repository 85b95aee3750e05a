#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/trace/dates.h"
#include "verify/trace/simulator.h"
#include "verify/verify.h"

#include <optional>
#include <string>

namespace proskill::verify {

/// The run that was replayed last. If another run starts with the same steps at the same dates,
/// only the rest of it is replayed.
class ReplayedRun {
public:
  ReplayedRun(const System& of, LimitWatch& watch) : system(of), limits(watch) {}

  /// Call this first. \param units number of time units in one unit of the model
  const Simulator& start(std::int64_t units);
  /// Takes a step after the first `before` steps. Returns why the step is not possible, or an empty
  /// string. \throw LimitMet
  [[nodiscard]] std::string take(std::size_t before, TransitionId step, std::int64_t date);
  /// The concrete state after this many steps.
  [[nodiscard]] const Concrete& after(std::size_t steps) const {
    return steps == 0 ? first : taken[steps - 1].after;
  }
  /// Whether the run comes to rest after this many steps.
  [[nodiscard]] Rest restAfter(std::size_t steps) const;
  /// The events of the step after the first `before` steps.
  [[nodiscard]] const std::vector<EventId>& events(std::size_t before) const {
    return taken[before].events;
  }
  /// Drops the end of a run that is too long to keep.
  void forgetLong();

private:
  struct Taken {
    TransitionId step = 0;
    std::int64_t date = 0;
    Concrete after;
    std::vector<EventId> events;
  };

  const System& system;
  LimitWatch& limits;
  std::int64_t scale = 0;
  std::optional<Simulator> simulator;
  Concrete first;
  std::vector<Taken> taken;
};

/// Executes the steps at their dates on concrete values and ages, and checks that the goal is
/// reached at the end. It uses the transitions, but no zones, clocks or reductions: every
/// transition has an age of its own. Returns what went wrong, or an empty string.
/// \param run may hold another run of the same system
/// \throw LimitMet
[[nodiscard]] std::string replay(const System& system, const Goal& goal, const Evidence& evidence,
                                 const Dating& dating, ReplayedRun& run);

} // namespace proskill::verify
