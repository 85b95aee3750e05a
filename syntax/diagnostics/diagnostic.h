#pragma once

#include "syntax/text/source.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::syntax {

/// Index of a file in the program's list of files; 0 is the root.
using FileId = std::uint32_t;

struct Location {
  FileId file = 0;
  Range range;
  friend bool operator==(const Location&, const Location&) = default;
};

enum class Severity : std::uint8_t { Error, Warning, Hint };

/// All diagnostics; syntax/diagnostics/codes.h names them.
enum class Code : std::uint16_t;

struct CodeInfo {
  Code code;
  std::string_view id; ///< `PS0101`: stable, shown to users
  Severity severity;
  std::string_view message;     ///< with `{}` for each argument
  std::string_view explanation; ///< one paragraph, for `proskill explain`
  std::string_view example;     ///< a program with this diagnostic; empty if it would be too long
};

[[nodiscard]] std::span<const CodeInfo> allCodes();
[[nodiscard]] const CodeInfo& info(Code code);
/// The code with this id, in upper or lower case; null if there is none.
[[nodiscard]] const CodeInfo* findCode(std::string_view id);

struct Related {
  Location location;
  std::string message;
};

/// An edit that removes the cause of a diagnostic: replaces `range` by `text`.
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

/// The message with each `{}` replaced by an argument. Very long quoted words are shortened.
[[nodiscard]] std::string filledIn(std::string_view message,
                                   std::span<const std::string> arguments);

} // namespace proskill::syntax
