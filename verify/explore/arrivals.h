#pragma once

#include "verify/explore/walker.h"
#include "verify/limits.h"
#include "verify/state/timing.h"

namespace proskill::verify {

/// Where a step leads to: behind the steps that stubborn sets take alone, in no time.
struct Arrival {
  std::vector<Word> state;
  std::vector<SignatureId> chain; ///< of the state behind the step, and of each behind those alone
  Steps alone;                    ///< the steps between these
};

/// Follows steps to the states that are stored.
class Arrivals {
public:
  /// \pre the arguments outlive this
  Arrivals(const Walker& with, Timing& of, LimitWatch& watch)
      : walker(with), timing(of), limits(watch) {}

  /// \param walk to the state behind a step. \throw LimitMet
  [[nodiscard]] Arrival at(Walk walk) const;
  /// What the steps alone leave of a zone of the state behind the step.
  /// \param own how many of the zone's last clocks are none of the system's; they go on
  [[nodiscard]] Dbm through(const Arrival& arrival, Dbm zone, std::uint32_t own) const;

private:
  const Walker& walker;
  Timing& timing;
  LimitWatch& limits;
};

} // namespace proskill::verify
