#pragma once

#include "verify/space/packed_rows.h"

#include <bit>
#include <cstdint>

namespace proskill::verify {

/// A growing list of numbers that takes as many bits for each as the greatest of them needs: none
/// while all are 0.
class Column {
public:
  [[nodiscard]] std::uint32_t at(std::size_t i) const {
    return static_cast<std::uint32_t>(rows.at(i));
  }
  void push(std::uint32_t number) {
    fit(number);
    rows.push(number);
  }
  /// \pre i < size()
  void set(std::size_t i, std::uint32_t number) {
    fit(number);
    rows.set(i, number);
  }
  [[nodiscard]] std::size_t size() const { return rows.size(); }
  [[nodiscard]] std::uint64_t bytes() const { return rows.bytes(); }
  /// Bytes that the next few numbers may allocate at once.
  [[nodiscard]] std::uint64_t growth() const { return rows.growth(); }
  /// Asks the processor to load a number soon.
  void prefetch(std::size_t i) const { rows.prefetch(i); }

private:
  void fit(std::uint32_t number) {
    const auto bits = static_cast<std::uint32_t>(std::bit_width(number));
    const std::uint32_t width = rows.rowWidth();
    if (bits > width) rows.widen(width, bits - width);
  }

  PackedRows rows;
};

} // namespace proskill::verify
