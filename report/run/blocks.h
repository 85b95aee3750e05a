#pragma once

#include "report/run/mcap.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace proskill::report::mcap {

/// Bytes of a file, read in blocks.
class Blocks {
public:
  explicit Blocks(const File& of, std::uint64_t bytes) : file(of), size(bytes) {}

  /// Some bytes; fewer at the end of the file. Valid until the next call.
  std::string_view at(std::uint64_t place, std::uint64_t bytes) {
    if (place < begin || place - begin + bytes > block.size()) {
      begin = place;
      block = place < file.size ? file.readAtMost(place, std::max(bytes, size)) : "";
    }
    return std::string_view(block).substr(static_cast<std::size_t>(place - begin),
                                          static_cast<std::size_t>(bytes));
  }

private:
  const File& file;
  std::uint64_t size;
  std::uint64_t begin = 0;
  std::string block;
};

} // namespace proskill::report::mcap
