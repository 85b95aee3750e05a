#include "syntax/text/xml.h"

#include "syntax/text/utf8.h"

namespace proskill::syntax {

namespace {

/// The characters of XML 1.0, section 2.2. UTF-8 has no surrogates.
bool isXml(char32_t c) {
  return (c >= 0x20 && c != 0xFFFE && c != 0xFFFF) || c == U'\n' || c == U'\t' || c == U'\r';
}

} // namespace

std::string xmlText(std::string_view text) {
  std::string out;
  forEachCharacter(text, [&](char32_t character, std::string_view bytes) {
    switch (character) {
    case U'&': out += "&amp;"; break;
    case U'<': out += "&lt;"; break;
    case U'>': out += "&gt;"; break;
    case U'"': out += "&quot;"; break;
    case U'\r': out += "&#13;"; break;
    default: out += isXml(character) ? bytes : kReplacement;
    }
  });
  return out;
}

std::string xmlAttribute(std::string_view text) {
  std::string out;
  for (const char c : xmlText(text)) {
    switch (c) {
    case '\n': out += "&#10;"; break;
    case '\t': out += "&#9;"; break;
    default: out += c;
    }
  }
  return out;
}

} // namespace proskill::syntax
