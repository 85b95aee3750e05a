#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/trace/dates.h"
#include "verify/trace/simulator.h"
#include "verify/verify.h"

#include <optional>
#include <string>

namespace proskill::verify {

/// The run that was replayed last. A run that begins with the same steps at the same dates is
/// replayed from where it parts from it.
class ReplayedRun {
public:
  ReplayedRun(const System& of, LimitWatch& watch) : system(of), limits(watch) {}

  /// To be called first. \param units of time in one unit of the model
  const Simulator& start(std::int64_t units);
  /// Takes a step: the one behind `before` others. Says why it is not possible, nothing where it
  /// is. \throw LimitMet
  [[nodiscard]] std::string take(std::size_t before, TransitionId step, std::int64_t date);
  /// What it came to after so many steps.
  [[nodiscard]] const Concrete& after(std::size_t steps) const {
    return steps == 0 ? first : taken[steps - 1].after;
  }
  /// Whether it comes to rest behind so many steps.
  [[nodiscard]] Rest restAfter(std::size_t steps) const;
  /// What the step behind `before` others passed.
  [[nodiscard]] const std::vector<EventId>& events(std::size_t before) const {
    return taken[before].events;
  }
  /// Forgets the end of a run that is too long to be kept.
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

/// Runs the steps at their dates on concrete values and ages, and looks whether what the goal asks
/// for is seen at the end. It knows the transitions, but neither zones nor clocks nor reductions:
/// every transition has its own age. Returns what went wrong, empty where nothing did.
/// \param run may hold another run of the system \throw LimitMet
[[nodiscard]] std::string replay(const System& system, const Goal& goal, const Evidence& evidence,
                                 const Dating& dating, ReplayedRun& run);

} // namespace proskill::verify
