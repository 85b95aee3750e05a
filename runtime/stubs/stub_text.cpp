#include "runtime/stubs/stub_text.h"

#include "runtime/stubs/stubs.h"

#include <fmt/format.h>

namespace proskill::runtime {

namespace {

constexpr std::string_view kMark = "Written by `proskill stubs`, which writes it anew: ";

bool isLower(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }
bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// FNV-1a, 64 bits.
std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return hash;
}

} // namespace

std::string upperCamel(std::string_view name) {
  std::string made;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') made += begins ? upper(c) : c;
    begins = c == '_';
  }
  return made;
}

std::string upperSnake(std::string_view name) {
  std::string made;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i > 0 && isUpper(name[i]) && isLower(name[i - 1])) made += '_';
    made += upper(name[i]);
  }
  return made;
}

std::string withStubMark(std::string_view comment, std::string_view text) {
  return fmt::format("{} {}{:016x}\n{}", comment, kMark, hashOf(text), text);
}

bool isUnchangedStub(std::string_view text) {
  const auto mark = text.find(kMark);
  const auto end = text.find('\n');
  if (mark == std::string_view::npos || end == std::string_view::npos || mark > end) return false;
  const auto written = text.substr(mark + kMark.size(), end - mark - kMark.size());
  return written == fmt::format("{:016x}", hashOf(text.substr(end + 1)));
}

} // namespace proskill::runtime
