#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace proskill::report {

enum class Colour : std::uint8_t { Bold, Dim, Red, Green, Yellow, Blue, Cyan };

/// Wraps text in terminal escapes, or returns it unchanged.
struct Paint {
  bool on = false;

  [[nodiscard]] std::string operator()(Colour colour, std::string_view text) const;
};

} // namespace proskill::report
