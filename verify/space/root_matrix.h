#pragma once

#include "verify/memory/large_vector.h"
#include "verify/space/roots.h"

#include <cstdint>

namespace proskill::verify {

/// A set of roots: a bit for each pair of numbers that may be one. Where the halves of states
/// change independently of each other, a good part of these pairs are roots, and each takes a few
/// bits.
class RootMatrix {
public:
  /// An empty set, with bits for all roots that a list can hold without wider rows.
  explicit RootMatrix(const Roots& roots) : RootMatrix(roots.leftWidth(), roots.rightWidth()) {}

  /// Bytes of a set for numbers of so many bits.
  [[nodiscard]] static std::uint64_t bytesFor(std::uint32_t leftBits, std::uint32_t rightBits) {
    const std::uint32_t bits = leftBits + rightBits;
    return bits < 6 ? sizeof(std::uint64_t) : std::uint64_t{1} << (bits - 3);
  }

  /// Whether there is a bit for the root.
  [[nodiscard]] bool hasRoomFor(const Root& root) const {
    return std::uint64_t{root.left} >> leftBits == 0 && std::uint64_t{root.right} >> rightBits == 0;
  }
  [[nodiscard]] bool contains(const Root& root) const {
    if (!hasRoomFor(root)) return false;
    const std::uint64_t bit = bitOf(root);
    return (words[bit / 64] >> bit % 64 & 1) != 0;
  }
  /// Several threads may call this at once. \pre hasRoomFor(root)
  void insert(const Root& root) {
    const std::uint64_t bit = bitOf(root);
    __atomic_fetch_or(&words[bit / 64], std::uint64_t{1} << bit % 64, __ATOMIC_RELAXED);
  }
  /// Asks the processor to load what contains() looks at.
  void prefetch(const Root& root) const {
    if (hasRoomFor(root)) __builtin_prefetch(&words[bitOf(root) / 64]);
  }
  [[nodiscard]] std::uint64_t bytes() const { return words.size() * sizeof(std::uint64_t); }

private:
  RootMatrix(std::uint32_t left, std::uint32_t right)
      : leftBits(left), rightBits(right), words(bytesFor(left, right) / sizeof(std::uint64_t)) {}
  [[nodiscard]] std::uint64_t bitOf(const Root& root) const {
    return root.left | std::uint64_t{root.right} << leftBits;
  }

  std::uint32_t leftBits;
  std::uint32_t rightBits;
  LargeVector<std::uint64_t> words;
};

} // namespace proskill::verify
