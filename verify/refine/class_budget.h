#pragma once

#include "verify/model/system.h"

#include <algorithm>

namespace proskill::verify {

/// \param left number of classes that searches may still find
inline void spend(std::uint64_t classes, std::uint64_t& left) { left -= std::min(left, classes); }

/// The price of a slice: it takes as long to make as exploring so many classes.
[[nodiscard]] inline std::uint64_t priceOfSlice(const System& whole) {
  constexpr std::uint64_t kTransitionsPerClass = 16;
  return whole.transitions.size() / kTransitionsPerClass;
}

} // namespace proskill::verify
