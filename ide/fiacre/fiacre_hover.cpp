#include "ide/fiacre/fiacre_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::ide {

namespace {

using fiacre::Block;
using fiacre::Mention;
using fiacre::NameKind;
using fiacre::TokenKind;

/// Replaces white space by single spaces.
std::string onOneLine(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!space)
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  return result;
}

/// Change of the nesting depth by a word.
int nesting(std::string_view word) {
  if (word == "(" || word == "{" || word == "{|" || word == "record" || word == "union") return 1;
  if (word == ")" || word == "}" || word == "|}" || word == "end") return -1;
  return 0;
}

/// Whether a word ends the items of a `var` or `port`.
bool isSection(std::string_view word) {
  constexpr std::string_view kSections[] = {"init",     "from",      "par",    "port",
                                            "priority", "begin",     "states", "var",
                                            "process",  "component", "is"};
  return std::ranges::find(kSections, word) != std::end(kSections);
}

std::string_view trimmed(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

std::string_view wordFor(NameKind kind) {
  switch (kind) {
  case NameKind::Variable: return "var ";
  case NameKind::Port: return "port ";
  default: return "";
  }
}

} // namespace

/// `x: 0..3 := 0`, even if the list has several names before the type.
std::string FiacreText::itemText(const Mention& name) const {
  auto at = std::ranges::lower_bound(words, name.end, {}, &fiacre::Token::begin);
  while (at != words.end() && (at->text == "," || at->kind == TokenKind::Name || at->text == "&"))
    ++at;
  if (at == words.end() || at->text != ":") return std::string(nameOf(name));
  const auto begin = at->begin;
  auto end = at->end();
  int depth = 0;
  bool inInterval = false;
  for (++at; at->kind != TokenKind::End; ++at) {
    const auto word = at->text;
    const bool bracket = word == "[" || word == "]";
    if (bracket && (inInterval || at[-1].text == "in")) {
      inInterval = !inInterval;
    } else if (depth == 0 && !inInterval) {
      const bool section = at->kind == TokenKind::Name && isSection(word);
      if (word == "," || word == ")" || word == "]" || section) break;
    }
    if (at->kind == TokenKind::Comment) continue;
    depth += nesting(word);
    depth += !inInterval && word == "[" ? 1 : !inInterval && word == "]" && depth > 0 ? -1 : 0;
    end = at->end();
  }
  return std::string(nameOf(name)) + onOneLine(text.substr(begin, end - begin));
}

/// The head of a block up to `is`.
std::string FiacreText::headText(const Block& block) const {
  auto at = std::ranges::lower_bound(words, block.begin, {}, &fiacre::Token::begin);
  while (at->text != "is" && at->begin < block.end) ++at;
  const auto end = std::min(at->begin, block.end);
  return std::string(trimmed(onOneLine(text.substr(block.begin, end - block.begin))));
}

std::string FiacreText::declarationText(Place declaration) const {
  const auto& name = mentions()[declaration];
  const auto* block = blocks[declaration];
  switch (name.kind) {
  case NameKind::Function:
  case NameKind::Process:
  case NameKind::Component: return block ? headText(*block) : std::string(nameOf(name));
  case NameKind::State: return "state " + std::string(nameOf(name));
  case NameKind::Tag: return "#" + std::string(nameOf(name));
  case NameKind::Variable:
  case NameKind::Parameter:
  case NameKind::Port: return std::string(wordFor(name.kind)) + itemText(name);
  default: break;
  }
  if (!block) return std::string(nameOf(name));
  return std::string(text.substr(block->begin, block->end - block->begin));
}

/// The comment lines above a position, otherwise the comment after it on its line.
std::string FiacreText::commentsOf(std::uint32_t begin) const {
  std::string result;
  auto lineBegin = text.rfind('\n', begin);
  lineBegin = lineBegin == std::string_view::npos ? 0 : lineBegin + 1;
  for (auto above = lineBegin; above > 0;) {
    const auto end = above - 1;
    const auto start = end == 0 ? 0 : text.rfind('\n', end - 1) + 1;
    const auto line = trimmed(text.substr(start, end - start));
    if (!line.starts_with("//")) break;
    const auto words = line.substr(std::min(line.find_first_not_of('/'), line.size()));
    if (!result.empty()) result.insert(0, 1, '\n');
    result.insert(0, trimmed(words));
    above = start;
  }
  if (!result.empty()) return result;
  const auto line = text.substr(begin, text.find('\n', begin) - begin);
  const auto sign = line.find("//");
  return sign == std::string_view::npos ? "" : std::string(trimmed(line.substr(sign + 2)));
}

std::optional<Hover> FiacreText::hover(syntax::Offset at) const {
  const auto place = mentionAt(at);
  if (place == kNowhere || declarations[place] == kNowhere) return std::nullopt;
  const auto declaration = declarations[place];
  const auto& declared = mentions()[declaration];
  Hover result{.range = {mentions()[place].begin, mentions()[place].end}};
  result.text.code(declarationText(declaration));
  const auto* block = blocks[declaration];
  const bool ofWhole = block && !isLocalName(declared.kind);
  if (const auto comment = commentsOf(ofWhole ? block->begin : declared.begin); !comment.empty())
    result.text.prose(comment);
  return result;
}

} // namespace proskill::ide
