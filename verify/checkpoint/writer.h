#pragma once

#include "verify/checkpoint_store.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace proskill::verify {

/// Writes numbers in few bytes. It needs no memory but one block.
class CheckpointWriter {
public:
  /// \pre the argument outlives this
  explicit CheckpointWriter(const CheckpointStore::Put& to) : put(to) {}

  void byte(std::uint8_t value) {
    block[used++] = static_cast<char>(value);
    if (used == block.size()) flush();
  }
  /// Seven bits a byte, the lowest first.
  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80));
    byte(static_cast<std::uint8_t>(value));
  }
  /// Numbers near 0 take few bytes, whatever their sign.
  void signedNumber(std::int64_t value) {
    number((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }
  void text(std::string_view value) {
    number(value.size());
    for (const char each : value) byte(static_cast<std::uint8_t>(each));
  }
  /// Call this at the end.
  void flush() {
    if (used != 0 && isWritten) isWritten = put({block.data(), used});
    used = 0;
  }
  /// Whether writing has failed, so that the rest is in vain.
  [[nodiscard]] bool hasFailed() const { return !isWritten; }

private:
  const CheckpointStore::Put& put;
  std::array<char, std::size_t{1} << 16> block;
  std::size_t used = 0;
  bool isWritten = true;
};

} // namespace proskill::verify
