#pragma once

#include "syntax/text/source.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::syntax {

/// A file of a program, by its place in the program's list of files; 0 is the root.
using FileId = std::uint32_t;

struct Location {
  FileId file = 0;
  Range range;
  friend bool operator==(const Location&, const Location&) = default;
};

enum class Severity : std::uint8_t { Error, Warning, Hint };

/// Every diagnostic that there is; by name in syntax/diagnostics/codes.h.
enum class Code : std::uint16_t;

struct CodeInfo {
  Code code;
  std::string_view id; ///< `PS0101`: stable, shown to users
  Severity severity;
  std::string_view message;     ///< with `{}` for each argument
  std::string_view explanation; ///< a paragraph for `proskill explain`
  std::string_view example;     ///< a program that raises it; empty where it would be too long
};

[[nodiscard]] std::span<const CodeInfo> allCodes();
[[nodiscard]] const CodeInfo& info(Code code);
/// By its id, upper or lower case; null where there is none.
[[nodiscard]] const CodeInfo* findCode(std::string_view id);

struct Related {
  Location location;
  std::string message;
};

/// An edit that mends the diagnostic: replace `range` by `text`.
struct Fix {
  std::string title; ///< "did you mean `camera_survey`?"
  Location location;
  std::string text;
};

struct Diagnostic {
  Code code;
  Severity severity;
  Location location;
  std::string message;
  std::vector<Related> related;
  std::vector<Fix> fixes;
};

/// A message with `{}` for each argument, filled in. Words of a text that are too long to be read
/// are shortened.
[[nodiscard]] std::string filledIn(std::string_view message,
                                   std::span<const std::string> arguments);

} // namespace proskill::syntax
