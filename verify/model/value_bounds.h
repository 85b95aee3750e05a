#pragma once

#include "verify/model/system.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// Arithmetic beyond it, or below its negation, is a fault.
inline constexpr std::int64_t kLargestNumber = std::int64_t{1} << 62;

/// Bounds of a node's value for all values of the cells within their ranges. The sides of a
/// conditional are bounded under its condition: `x < 5 ? x + 1 : 5` is at most 5.
struct ValueBounds {
  std::int64_t low = 0;
  std::int64_t high = 0;
};
[[nodiscard]] ValueBounds valueBounds(const System& system, NodeId node);

/// A condition that is known to be true, or to be false.
struct KnownTruth {
  NodeId condition = 0;
  bool truth = true;
};
/// The bounds where all of this is known; nothing if it contradicts itself.
[[nodiscard]] std::optional<ValueBounds> valueBounds(const System& system, NodeId node,
                                                     const std::vector<KnownTruth>& known);

/// Whether evaluation may cause a fault.
[[nodiscard]] bool mayFail(const System& system, NodeId node);

} // namespace proskill::verify
