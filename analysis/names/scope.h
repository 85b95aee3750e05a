#pragma once

#include "syntax/text/source.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace proskill::analysis {

using syntax::FileId;
using syntax::Location;

/// The definitions that a check reads: after an edit, those that it may affect.
struct Scope {
  bool isAll = true;
  /// If not all: the definitions that begin in one of these locations. The locations are in the
  /// order of the files and their texts and do not overlap.
  std::vector<Location> within{};

  [[nodiscard]] bool holds(FileId file, syntax::Offset begin) const {
    if (isAll) return true;
    auto after =
        std::ranges::upper_bound(within, std::tuple(file, begin), {}, [](const Location& it) {
          return std::tuple(it.file, it.range.begin);
        });
    if (after == within.begin()) return false;
    const Location& last = *std::prev(after);
    return last.file == file && last.range.contains(begin);
  }
};

} // namespace proskill::analysis
