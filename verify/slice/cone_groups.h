#pragma once

#include "verify/model/bits.h"

#include <cstddef>
#include <vector>

namespace proskill::verify {

/// Questions about nearly the same part of a system.
struct ConeGroup {
  Bits cone;                      ///< the instances that influence the questions; see Slicer::cone
  std::vector<std::size_t> goals; ///< by index
};

/// Joins groups: a cone that is not much smaller than one that contains it joins it, since both can
/// be explored together at little more than the cost of the larger one.
/// \return the groups, the largest cones first
[[nodiscard]] std::vector<ConeGroup> joined(std::vector<ConeGroup> groups);

} // namespace proskill::verify
