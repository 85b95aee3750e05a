#pragma once

#include "tests/support/oracle/interpreter.h"

#include <set>

namespace proskill::oracle {

/// A bound on a difference of two dates: at most `value`, or less than it.
struct Bound {
  std::int64_t value = 0;
  bool strict = false;
  bool infinite = false;
  friend auto operator<=>(const Bound&, const Bound&) = default;
};

/// Possible firing dates of the enabled transitions, relative to now: bounds of `x_i - x_j`,
/// tightest, row by row. Index 0 is now, index i the i-th clock.
struct Domain {
  std::vector<ClockId> clocks;
  std::vector<Bound> bounds;
  friend auto operator<=>(const Domain&, const Domain&) = default;

  [[nodiscard]] std::size_t size() const { return clocks.size() + 1; }
  [[nodiscard]] Bound& at(std::size_t i, std::size_t j) { return bounds[i * size() + j]; }
  [[nodiscard]] const Bound& at(std::size_t i, std::size_t j) const {
    return bounds[i * size() + j];
  }
};

/// The counts that sift prints.
struct ClassCounts {
  std::size_t classes = 0;
  std::size_t markings = 0;
  std::size_t domains = 0;
  std::size_t transitions = 0;
  bool complete = false;
};

/// The textbook graph of state classes: a class is a discrete state with a domain over all its
/// enabled transitions, and classes are merged if both are equal. Berthomieu and Diaz, "Modeling
/// and verification of time dependent systems using time Petri nets", TSE 1991.
[[nodiscard]] ClassCounts countClasses(const Interpreter& model, std::size_t limit);

} // namespace proskill::oracle
