#pragma once

#include "verify/model/system.h"

#include <cstdint>
#include <vector>

namespace proskill::verify {

/// Numbers of one table, by those of another.
class Translation {
public:
  /// The number here of what has a number there; `make` makes it once.
  template <class Make> std::uint32_t get(std::uint32_t number, Make make) {
    if (number >= known.size()) known.resize(number + 1, kNone);
    if (known[number] == kNone) known[number] = make();
    return known[number];
  }

private:
  std::vector<std::uint32_t> known; ///< kNone where it was not asked for yet
};

} // namespace proskill::verify
