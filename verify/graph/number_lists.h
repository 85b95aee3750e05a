#pragma once

#include "verify/model/number_table.h"
#include "verify/model/release.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace proskill::verify {

/// Lists of numbers, each stored once, one after the other.
class NumberLists {
public:
  /// The number of a list, and whether it is new.
  struct Added {
    std::uint32_t id = 0;
    bool isNew = false;
  };

  Added add(std::span<const std::uint32_t> list) {
    const auto next = size();
    const auto id = table.findOrAdd(hashOfAll(list), next, [&](std::uint32_t other) {
      return std::ranges::equal(at(other), list);
    });
    if (id != next) return {id, false};
    items.insert(items.end(), list.begin(), list.end());
    ends.push_back(items.size());
    return {id, true};
  }
  /// It is valid until the next list is added.
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t id) const {
    const std::uint64_t first = id == 0 ? 0 : ends[id - 1];
    return {items.data() + first, static_cast<std::size_t>(ends[id] - first)};
  }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(ends.size()); }
  void clear() {
    release(items);
    release(ends);
    table = {};
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return items.capacity() * sizeof items[0] + ends.capacity() * sizeof ends[0] + table.bytes();
  }
  /// Bytes that the next few lists may allocate at once.
  [[nodiscard]] std::uint64_t growth() const {
    return growthOf(items) + growthOf(ends) + table.growth();
  }

private:
  LargeVector<std::uint32_t> items;
  LargeVector<std::uint64_t> ends; ///< by list
  NumberTable table;
};

} // namespace proskill::verify
