#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace proskill::test {

/// Random choices that are the same with every standard library: the standard defines the engine,
/// but not the distributions.
class RandomSource {
public:
  explicit RandomSource(std::uint64_t seed) : engine(seed) {}

  /// From 0 to `count` - 1. \pre count > 0
  [[nodiscard]] std::size_t below(std::size_t count) { return engine() % count; }
  [[nodiscard]] std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::size_t>(high - low + 1)));
  }
  [[nodiscard]] bool chance(unsigned percent) { return below(100) < percent; }
  template <class Item> [[nodiscard]] const Item& pick(const std::vector<Item>& items) {
    return items[below(items.size())];
  }

private:
  std::mt19937_64 engine;
};

} // namespace proskill::test
