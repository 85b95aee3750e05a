#pragma once

#include "verify/explore/walker.h"
#include "verify/limits.h"
#include "verify/state/timing.h"

namespace proskill::verify {

/// The stored state that a step leads to, after the steps that stubborn sets fire alone in no time.
struct Arrival {
  std::vector<Word> state;
  std::vector<SignatureId> chain; ///< of the state after the step, and after each step fired alone
  Steps alone;                    ///< the steps fired alone
};

/// Follows steps to the states that the exploration stores.
class Arrivals {
public:
  /// \pre the arguments outlive this
  Arrivals(const Walker& with, Timing& of, LimitWatch& watch)
      : walker(with), timing(of), limits(watch) {}

  /// \param walk at the state after a step
  /// \throw LimitMet
  [[nodiscard]] Arrival at(Walk walk) const;
  /// The zone after the steps fired alone, from a zone of the state after the step.
  /// \param own how many of the zone's last clocks are not clocks of the system; these keep running
  [[nodiscard]] Dbm through(const Arrival& arrival, Dbm zone, std::uint32_t own) const;

private:
  const Walker& walker;
  Timing& timing;
  LimitWatch& limits;
};

} // namespace proskill::verify
