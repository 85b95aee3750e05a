#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace proskill::runtime {

/// Line and column, in characters, both from 1.
struct FilePlace {
  std::uint32_t line = 1;
  std::uint32_t column = 1;

  /// `3:14`
  [[nodiscard]] std::string text() const {
    return std::to_string(line) + ":" + std::to_string(column);
  }
};

/// Why a platform file or a script cannot be used.
struct FileError {
  std::string why;
  std::optional<FilePlace> place{}; ///< in the file; nothing: something is missing in it
  std::string skill{};              ///< the basic skill that it does not suit; empty: the whole

  /// `3:14: MESSAGE`
  [[nodiscard]] std::string text() const { return (place ? place->text() + ": " : "") + why; }
};

/// Empty: the file can be used.
using FileErrors = std::vector<FileError>;

} // namespace proskill::runtime
