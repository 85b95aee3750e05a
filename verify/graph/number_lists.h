#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace proskill::verify {

/// Short lists of numbers in one array. A list that outgrows its place moves to the end.
class NumberLists {
public:
  std::uint32_t add() {
    heads.emplace_back();
    return static_cast<std::uint32_t>(heads.size() - 1);
  }
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t list) const {
    return {pool.data() + heads[list].offset, heads[list].size};
  }
  bool insert(std::uint32_t list, std::uint32_t number) {
    if (std::ranges::find(at(list), number) != at(list).end()) return false;
    Head& head = heads[list];
    if (head.size == head.capacity) move(head);
    pool[head.offset + head.size++] = number;
    return true;
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return heads.capacity() * sizeof(Head) + pool.capacity() * sizeof(std::uint32_t);
  }

private:
  struct Head {
    std::uint64_t offset = 0;
    std::uint32_t size = 0;
    std::uint32_t capacity = 0;
  };

  void move(Head& head) {
    const std::uint64_t offset = pool.size();
    head.capacity = std::max(2U, head.capacity * 2);
    pool.resize(offset + head.capacity);
    std::copy_n(pool.begin() + static_cast<std::ptrdiff_t>(head.offset), head.size,
                pool.begin() + static_cast<std::ptrdiff_t>(offset));
    head.offset = offset;
  }

  std::vector<Head> heads;
  std::vector<std::uint32_t> pool;
};

} // namespace proskill::verify
