#pragma once

#include "report/run/mcap.h"

#include <algorithm>
#include <string>

namespace proskill::test {

/// A file in memory, which must outlive it.
inline report::mcap::File fileOf(const std::string& bytes) {
  return {bytes.size(), [&](std::uint64_t at, std::uint64_t size) {
            return bytes.substr(std::min<std::uint64_t>(at, bytes.size()), size);
          }};
}

} // namespace proskill::test
