#pragma once

#include "verify/space/packed_rows.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace proskill::verify {

/// The pair of numbers at the root of a state tree.
struct Root {
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  friend bool operator==(const Root&, const Root&) = default;
};

/// A growing list of roots. Both numbers of a root are next to each other, each in as many bits as
/// the greatest of them needs.
class Roots {
public:
  [[nodiscard]] Root at(std::size_t i) const {
    const std::uint64_t row = rows.at(i);
    return {static_cast<std::uint32_t>(row & PackedRows::maskOf(leftBits)),
            static_cast<std::uint32_t>(row >> leftBits)};
  }
  void push(const Root& root) {
    greatest = {std::max(greatest.left, root.left), std::max(greatest.right, root.right)};
    const std::uint32_t rightBits = rows.rowWidth() - leftBits;
    if (const auto bits = bitsOf(root.right); bits > rightBits)
      rows.widen(rows.rowWidth(), bits - rightBits);
    if (const auto bits = bitsOf(root.left); bits > leftBits) {
      rows.widen(leftBits, bits - leftBits);
      leftBits = bits;
    }
    rows.push(root.left | std::uint64_t{root.right} << leftBits);
  }
  /// Bits of the left numbers.
  [[nodiscard]] std::uint32_t leftWidth() const { return leftBits; }
  [[nodiscard]] std::uint32_t rightWidth() const { return rows.rowWidth() - leftBits; }
  /// The greatest left number of a root, and the greatest right one.
  [[nodiscard]] Root greatestNumbers() const { return greatest; }
  [[nodiscard]] std::uint64_t bytes() const { return rows.bytes(); }
  /// Bytes that the next few roots may allocate at once.
  [[nodiscard]] std::uint64_t growth() const { return rows.growth(); }
  /// Asks the processor to load a root soon.
  void prefetch(std::size_t i) const { rows.prefetch(i); }

private:
  [[nodiscard]] static std::uint32_t bitsOf(std::uint32_t number) {
    return static_cast<std::uint32_t>(std::bit_width(number));
  }

  PackedRows rows; ///< the left number below the right one
  std::uint32_t leftBits = 0;
  Root greatest;
};

} // namespace proskill::verify
