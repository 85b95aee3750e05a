#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace proskill::groot {

/// Appends the lowest bytes of a number, the lowest first.
inline void addBytes(std::string& to, std::uint64_t number, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to += static_cast<char>(number >> 8 * i & 0xFF);
}

/// Appends a change as logs and recordings have it, in 9 bytes.
/// \param time in microseconds
inline void addChange(std::string& to, std::uint64_t time, std::uint16_t uid, std::uint8_t status) {
  addBytes(to, time, 6);
  addBytes(to, uid, 2);
  addBytes(to, status, 1);
}

} // namespace proskill::groot
