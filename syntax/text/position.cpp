#include "syntax/text/position.h"

#include "syntax/text/utf8.h"

#include <algorithm>

namespace proskill::syntax {

namespace {

/// Size of a character: in bytes, and in units of an encoding.
struct Character {
  std::size_t bytes;
  std::uint32_t units;
};

bool isAscii(char c) { return (static_cast<unsigned char>(c) & 0x80) == 0; }

Character characterAt(std::string_view text, Encoding encoding) {
  const auto length = characterLength(text);
  if (encoding == Encoding::Utf8) return {length, static_cast<std::uint32_t>(length)};
  return {length, encoding == Encoding::Utf16 && length == 4 ? 2U : 1U};
}

} // namespace

EditorPosition toEditor(std::string_view text, const LineIndex& lines, Offset at,
                        Encoding encoding) {
  std::uint32_t line = 0;
  return toEditor(text, lines, at, encoding, line);
}

EditorPosition toEditor(std::string_view text, const LineIndex& lines, Offset at, Encoding encoding,
                        std::uint32_t& line) {
  const auto column = lines.position(at, line).column;
  if (encoding == Encoding::Utf8) return {line, column};
  auto before = text.substr(at - column, column);
  if (std::ranges::all_of(before, isAscii)) return {line, column};
  EditorPosition position{line, 0};
  while (!before.empty()) {
    auto character = characterAt(before, encoding);
    position.character += character.units;
    before.remove_prefix(character.bytes);
  }
  return position;
}

EditorPosition LineWalk::to(Offset at) {
  if (at >= nextLine) {
    auto line = lines.position(at).line;
    here = lines.offset({line, 0});
    bool last = line + 1 >= lines.lineCount();
    nextLine = last ? UINT32_MAX : lines.offset({line + 1, 0});
    position = {line, 0};
  }
  while (here < at) {
    auto character = characterAt(text.substr(here, at - here), encoding);
    position.character += character.units;
    here += static_cast<Offset>(character.bytes);
  }
  return position;
}

Offset fromEditor(std::string_view text, const LineIndex& lines, EditorPosition position,
                  Encoding encoding) {
  if (position.line >= lines.lineCount()) return static_cast<Offset>(text.size());
  auto range = lines.line(position.line, text);
  auto rest = text.substr(range.begin, range.length());
  auto wanted = position.character;
  auto at = range.begin;
  while (!rest.empty()) {
    auto character = characterAt(rest, encoding);
    if (character.units > wanted) break;
    wanted -= character.units;
    at += static_cast<Offset>(character.bytes);
    rest.remove_prefix(character.bytes);
  }
  return at;
}

} // namespace proskill::syntax
