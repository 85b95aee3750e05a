#include "verify/export/identifiers.h"

namespace proskill::verify {

namespace {

bool isAlphanumeric(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9');
}

} // namespace

std::string Identifiers::make(std::string_view prefix, std::string_view name) {
  std::string plain(prefix);
  for (const char c : name) {
    const bool twice = !isAlphanumeric(c) && plain.ends_with('_');
    if (!twice) plain += isAlphanumeric(c) ? c : '_';
  }
  std::string made = plain;
  for (int i = 2; !taken.insert(made).second; ++i) made = plain + "__" + std::to_string(i);
  return made;
}

} // namespace proskill::verify
