#include "syntax/diagnostics/diagnostic.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/text/quote.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace proskill::syntax {
namespace {

constexpr std::array kCodes = {
#define DIAGNOSTIC(name, code, severity, message, explanation, example)                            \
  CodeInfo{Code::name, code, Severity::severity, message, explanation, example},
#include "syntax/diagnostics/diagnostics.def"
#undef DIAGNOSTIC
};

bool sameLetter(char a, char b) {
  return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
}

} // namespace

std::span<const CodeInfo> allCodes() { return kCodes; }

const CodeInfo& info(Code code) { return kCodes.at(static_cast<std::size_t>(code)); }

const CodeInfo* findCode(std::string_view id) {
  auto found = std::ranges::find_if(
      kCodes, [&](const CodeInfo& entry) { return std::ranges::equal(entry.id, id, sameLetter); });
  return found == kCodes.end() ? nullptr : &*found;
}

/// Inserts the arguments. An argument between backquotes is a word of the program, which may
/// contain any character; others are prose, which may quote words.
std::string filledIn(std::string_view message, std::span<const std::string> arguments) {
  std::string result;
  bool isQuoted = false;
  for (const auto& argument : arguments) {
    const auto place = message.find("{}");
    if (place == std::string_view::npos) break; // there may be more arguments than placeholders
    const auto before = message.substr(0, place);
    isQuoted ^= std::ranges::count(before, '`') % 2 == 1;
    result.append(before).append(isQuoted ? shortened(argument) : withShortQuotes(argument));
    message.remove_prefix(place + 2);
  }
  return result.append(message);
}

} // namespace proskill::syntax
