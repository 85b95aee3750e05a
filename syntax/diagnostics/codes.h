#pragma once

#include "syntax/diagnostics/diagnostic.h"

#include <array>

#include <fmt/format.h>

namespace proskill::syntax {

/// All diagnostics, generated from diagnostics.def.
enum class Code : std::uint16_t {
#define DIAGNOSTIC(name, code, severity, message, explanation, example) name,
#include "syntax/diagnostics/diagnostics.def"
#undef DIAGNOSTIC
};

/// The number of arguments that a message has placeholders for.
[[nodiscard]] constexpr std::size_t argumentsOf(std::string_view message) {
  std::size_t count = 0;
  for (auto at = message.find("{}"); at != message.npos; at = message.find("{}", at + 2)) ++count;
  return count;
}

inline constexpr std::array kArguments = {
#define DIAGNOSTIC(name, code, severity, message, explanation, example) argumentsOf(message),
#include "syntax/diagnostics/diagnostics.def"
#undef DIAGNOSTIC
};

/// A code together with `count` arguments for its message. A code whose message needs more
/// arguments does not compile; a message may need fewer.
template <std::size_t count> struct CodeFor {
  Code code;

  consteval CodeFor(Code of) : code(of) {
    if (kArguments[static_cast<std::size_t>(of)] > count) throw "the message wants more arguments";
  }
  template <std::size_t fewer>
  requires(fewer < count) constexpr CodeFor(CodeFor<fewer> of) : code(of.code) {}
};

/// A diagnostic with the severity of its code and its message, filled in with `arguments`.
template <class... Arguments>
[[nodiscard]] Diagnostic makeDiagnostic(CodeFor<sizeof...(Arguments)> code, Location location,
                                        const Arguments&... arguments) {
  const CodeInfo& entry = info(code.code);
  // `fmt::to_string` of an empty text would copy from a null pointer.
  const std::array<std::string, sizeof...(arguments)> words{fmt::format("{}", arguments)...};
  return {code.code, entry.severity, location, filledIn(entry.message, words), {}, {}};
}

} // namespace proskill::syntax
