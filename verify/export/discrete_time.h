#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// The bounds of a model in ticks, as integers.
class DiscreteTime {
public:
  explicit DiscreteTime(const System& system);

  /// The least number of ticks after which the transition may fire.
  [[nodiscard]] std::int64_t lower(const fiacre::Interval& interval) const;
  /// The greatest number of ticks until which it must fire. \pre it has an upper bound
  [[nodiscard]] std::int64_t upper(const fiacre::Interval& interval) const;
  /// By clock: the number of ticks from which on more of them make no difference.
  [[nodiscard]] const std::vector<std::int64_t>& most() const { return greatest; }
  /// A tick is unit/scale units of the model.
  [[nodiscard]] std::int64_t unit() const { return divisor; }
  [[nodiscard]] std::int64_t scale() const { return factor; }
  [[nodiscard]] bool isExact() const { return factor == 1; } ///< all constraints are closed

private:
  std::int64_t divisor = 0; ///< greatest common divisor of all bounds
  std::int64_t factor = 1;  ///< 2 if a constraint is open, so that every interval has a tick in it
  std::vector<std::int64_t> greatest;
};

} // namespace proskill::verify
