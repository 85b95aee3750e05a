#include "syntax/text/position.h"

#include <catch2/catch.hpp>

#include <string>

using namespace proskill;
using namespace proskill::syntax;

namespace {

constexpr syntax::Encoding kAll[] = {syntax::Encoding::Utf8, syntax::Encoding::Utf16,
                                     syntax::Encoding::Utf32};

} // namespace

TEST_CASE("a column is counted in the encoding's units") {
  const std::string text = "; aé€😀z\nb";
  const syntax::LineIndex lines(text);
  auto z = static_cast<syntax::Offset>(text.find('z'));
  CHECK(syntax::toEditor(text, lines, z, syntax::Encoding::Utf8) == syntax::EditorPosition{0, 12});
  CHECK(syntax::toEditor(text, lines, z, syntax::Encoding::Utf16) == syntax::EditorPosition{0, 7});
  CHECK(syntax::toEditor(text, lines, z, syntax::Encoding::Utf32) == syntax::EditorPosition{0, 6});
}

TEST_CASE("every start of a character goes to the editor and back") {
  const std::string text = "(é €)\r\n; 😀 \xF0\x9F\x98 x\n\nend";
  const syntax::LineIndex lines(text);
  for (auto encoding : kAll)
    for (syntax::Offset at = 0; at <= text.size(); ++at) {
      bool inside = at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
      bool inLineEnd = at > 0 && text[at - 1] == '\r';
      if (inside || inLineEnd) continue;
      CHECK(syntax::fromEditor(text, lines, syntax::toEditor(text, lines, at, encoding),
                               encoding) == at);
    }
}

TEST_CASE("a position beyond the line is its end, beyond the text the text's end") {
  const std::string text = "ab\r\ncd";
  const syntax::LineIndex lines(text);
  for (auto encoding : kAll) {
    CHECK(syntax::fromEditor(text, lines, {0, 99}, encoding) == 2);
    CHECK(syntax::fromEditor(text, lines, {1, 99}, encoding) == 6);
    CHECK(syntax::fromEditor(text, lines, {9, 0}, encoding) == 6);
  }
}

TEST_CASE("a position within a character is the character's start") {
  const std::string text = "a😀b";
  const syntax::LineIndex lines(text);
  CHECK(syntax::fromEditor(text, lines, {0, 2}, syntax::Encoding::Utf16) == 1);
  CHECK(syntax::fromEditor(text, lines, {0, 3}, syntax::Encoding::Utf8) == 1);
}
