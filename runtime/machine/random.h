#pragma once

#include <cstdint>

namespace proskill::runtime {

/// Pseudorandom numbers from a seed, the same on every machine. Steele, Lea, Flood, "Fast
/// splittable pseudorandom number generators", OOPSLA 2014.
class Random {
public:
  explicit Random(std::uint64_t seed) : state(seed) {}

  std::uint64_t next() {
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t mixed = state;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9U;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebU;
    return mixed ^ (mixed >> 31);
  }

  /// A number from 0 to count - 1. \pre count > 0
  std::uint64_t below(std::uint64_t count) { return next() % count; }

  /// A number from `first` to `last`, inclusive. \pre first <= last
  std::int64_t between(std::int64_t first, std::int64_t last) {
    return first + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(last - first) + 1));
  }

private:
  std::uint64_t state;
};

} // namespace proskill::runtime
