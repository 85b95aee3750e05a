#include "syntax/diagnostic.h"
#include "syntax/codes.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace proskill::syntax {
namespace {

constexpr std::array kCodes = {
#define DIAGNOSTIC(name, code, severity, message, explanation, example)                            \
  CodeInfo{Code::name, code, Severity::severity, message, explanation, example},
#include "syntax/diagnostics.def"
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

} // namespace proskill::syntax
