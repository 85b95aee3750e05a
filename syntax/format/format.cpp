#include "syntax/format/format.h"

#include "syntax/format/format_layout.h"
#include "syntax/format/indent.h"
#include "syntax/text/change.h"
#include "syntax/text/characters.h"

#include <algorithm>

namespace proskill::syntax {

namespace {

std::vector<Gap> gapsOf(const Document& document) {
  Layout layout(document.text());
  for (const Region& region : document.regions()) {
    if (auto boxes = boxesOf(document.text(), region))
      layout.region(*boxes);
    else
      layout.leave(region.range);
  }
  layout.finish();
  return std::move(layout.gaps);
}

/// The line end of the text's first line, which is used for all.
std::string_view lineEndOf(std::string_view text) {
  auto first = text.find('\n');
  return first != std::string_view::npos && first > 0 && text[first - 1] == '\r' ? "\r\n" : "\n";
}

std::string written(const Gap& gap, std::string_view lineEnd) {
  std::string result;
  for (std::uint32_t i = 0; i < gap.lines; ++i) result += lineEnd;
  return result.append(gap.spaces, ' ');
}

/// Whether a position is inside a `\r\n`.
bool splitsLineEnd(std::string_view text, std::size_t at) {
  return at > 0 && at < text.size() && text[at - 1] == '\r' && text[at] == '\n';
}

/// The minimal change from one piece of white space to another.
TextEdit smallestEdit(std::string_view before, std::string_view after, Offset at) {
  auto [head, tail] = commonEnds(before, after);
  while (splitsLineEnd(before, head) || splitsLineEnd(after, head)) --head;
  while (splitsLineEnd(before, before.size() - tail) || splitsLineEnd(after, after.size() - tail))
    --tail;
  auto offset = [&](std::size_t in) { return at + static_cast<Offset>(in); };
  return {{offset(head), offset(before.size() - tail)},
          std::string(after.substr(head, after.size() - tail - head))};
}

bool isBlank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

/// Characters of operators, which may follow each other in any number.
bool isSign(char c) { return std::string_view("=<>/&|~^+*!-").contains(c); }

/// Whether two tokens would become others without space between them.
bool wouldJoin(char end, char begin) {
  const bool words = (isWordCharacter(begin) || begin == '-' || begin == '.') &&
                     (isWordCharacter(end) || std::string_view("$:.-").contains(end));
  return words || (isSign(begin) && isSign(end));
}

/// A minus and a name are two tokens with or without space between them; a minus and a number are
/// one.
bool endsAtName(char end, char begin) {
  return end == '-' && isWordCharacter(begin) && (begin < '0' || begin > '9');
}

/// The position after the string that begins there.
std::size_t endOfString(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at)
    if (text[at] == '\\') ++at;
  return std::min(at + 1, text.size());
}

enum class Spaces : std::uint8_t { None, BetweenWords };

/// The text with the minimal white space that separates its tokens, or with none.
std::string tokensOf(const Document& document, Spaces spaces) {
  std::string tokens;
  std::string_view text = document.text();
  auto comment = document.comments().begin();
  bool apart = false;
  for (std::size_t at = 0; at < text.size();) {
    auto end = at + 1;
    if (comment != document.comments().end() && comment->begin == at) {
      end = comment++->end;
      auto words = text.substr(at, end - at);
      tokens.append(words.substr(0, words.find_last_not_of(" \t\r") + 1)) += '\n';
    } else if (isBlank(text.substr(at, 1))) {
      apart = true;
      at = end;
      continue;
    } else {
      if (text[at] == '"') end = endOfString(text, at);
      if (spaces == Spaces::BetweenWords && !tokens.empty() && wouldJoin(tokens.back(), text[at]) &&
          (apart || endsAtName(tokens.back(), text[at])))
        tokens += ' ';
      tokens += text.substr(at, end - at);
    }
    apart = false;
    at = end;
  }
  return tokens;
}

/// The words as they were parsed, one per line.
std::string wordsOf(const Document& document) {
  std::string words;
  for (const Region& region : document.regions()) {
    const auto text =
        std::string_view(document.text()).substr(region.range.begin, region.range.length());
    if (region.tree->empty()) words += text;
    for (const Node& node : *region.tree) {
      if (node.size > 1 || node.kind == NodeKind::Comment) continue;
      auto word = std::string(text.substr(node.range.begin, node.range.length()));
      if (node.kind != NodeKind::StringContent)
        std::erase_if(word, [](char c) { return isBlank({&c, 1}); });
      if (!word.empty()) words.append(word) += '\n';
    }
  }
  return words;
}

std::vector<TextEdit> editsOf(std::string_view text, const std::vector<Gap>& gaps) {
  std::vector<TextEdit> edits;
  auto lineEnd = lineEndOf(text);
  for (const Gap& gap : gaps) {
    auto before = text.substr(gap.old.begin, gap.old.length());
    auto after = written(gap, lineEnd);
    if (before != after && isBlank(before))
      edits.push_back(smallestEdit(before, after, gap.old.begin));
  }
  return edits;
}

bool inCommentOrString(const Document& document, Offset caret) {
  for (Range comment : document.comments())
    if (comment.begin < caret && caret <= comment.end) return true;
  auto line = document.lines().line(document.lines().position(caret).line, document.text());
  auto before = std::string_view(document.text()).substr(line.begin, caret - line.begin);
  std::size_t at = before.find('"');
  while (at < before.size()) {
    auto end = endOfString(before, at);
    if (end >= before.size() && (before.size() - at < 2 || before.back() != '"')) return true;
    at = before.find('"', end);
  }
  return false;
}

/// Edits of lines as they are typed, from the top down.
class LineEdits {
public:
  explicit LineEdits(const Document& document) : document(document), text(document.text()) {}

  /// The white space at both ends of a line that the caret has left.
  void leave(std::uint32_t number) {
    auto content = contentOf(number);
    // such a comment may be about the definition that follows
    if (!content.empty() && (text[content.begin] != ';' || content.begin > lineAt(number).begin))
      indent(number);
    add({content.end, lineAt(number).end}, 0);
  }

  /// The indentation, below the lines as edited.
  void indent(std::uint32_t number) {
    auto line = lineAt(number);
    auto begin = regionAt(document, line.begin).begin;
    auto above = edited({begin, line.begin});
    auto content = contentOf(number);
    add({line.begin, content.empty() ? line.end : content.begin},
        indentation(above, text.substr(line.begin, line.length())));
  }

  std::vector<TextEdit> edits;

private:
  [[nodiscard]] Range lineAt(std::uint32_t number) const {
    return document.lines().line(number, text);
  }

  /// The line without white space at its ends; of an empty line, its beginning.
  [[nodiscard]] Range contentOf(std::uint32_t number) const {
    auto line = lineAt(number);
    auto content = text.substr(line.begin, line.length());
    auto first = content.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {line.begin, line.begin};
    auto last = content.find_last_not_of(" \t") + 1;
    return {line.begin + static_cast<Offset>(first), line.begin + static_cast<Offset>(last)};
  }

  [[nodiscard]] std::string edited(Range range) const {
    std::vector<TextEdit> inside;
    for (const auto& [at, put] : edits)
      if (at.begin >= range.begin) inside.push_back({at.moved(-range.begin), put});
    return applyEdits(text.substr(range.begin, range.length()), inside);
  }

  void add(Range range, std::uint32_t spaces) {
    auto before = text.substr(range.begin, range.length());
    auto after = std::string(spaces, ' ');
    if (before != after) edits.push_back(smallestEdit(before, after, range.begin));
  }

  const Document& document;
  std::string_view text;
};

std::vector<TextEdit> newLine(const Document& document, Offset caret) {
  std::string_view text = document.text();
  auto number = document.lines().position(caret).line;
  auto begin = document.lines().line(number, text).begin;
  if (!isBlank(text.substr(begin, caret - begin))) return {};
  LineEdits lines(document);
  if (number > 0) lines.leave(number - 1);
  lines.indent(number);
  return lines.edits;
}

/// The definition that ends there; empty if there is none.
Range definitionEndingAt(const Boxes& boxes, Offset end) {
  for (std::size_t at = 0; at < boxes.size(); at += boxes[at].size)
    if (boxes[at].shape == BoxShape::Form && boxes[at].range.end == end) return boxes[at].range;
  return {};
}

std::vector<TextEdit> closedDefinition(const Document& document, Offset caret) {
  for (const Region& region : document.regions()) {
    if (caret <= region.range.begin || caret > region.range.end) continue;
    auto boxes = boxesOf(document.text(), region);
    if (!boxes) return {};
    auto closed = definitionEndingAt(*boxes, caret);
    Layout layout(document.text());
    layout.leave({0, region.range.begin});
    layout.region(*boxes);
    auto edits = editsOf(document.text(), layout.gaps);
    std::erase_if(edits, [&](const TextEdit& edit) {
      return edit.range.begin <= closed.begin || edit.range.end >= closed.end;
    });
    return edits;
  }
  return {};
}

} // namespace

std::vector<TextEdit> format(const Document& document) {
  return editsOf(document.text(), gapsOf(document));
}

std::vector<Range> unformattable(const Document& document) {
  std::vector<Range> result;
  for (const Region& region : document.regions())
    if (!region.range.empty() && !boxesOf(document.text(), region)) result.push_back(region.range);
  return result;
}

std::vector<TextEdit> formatRange(const Document& document, Range lines) {
  const auto& index = document.lines();
  auto first = index.offset({index.position(lines.begin).line, 0});
  auto lastLine = index.position(lines.end);
  // a selection of whole lines ends at the start of the next line
  bool whole = lastLine.column == 0 && lines.end > lines.begin;
  auto last = whole ? lines.end - 1 : index.line(lastLine.line, document.text()).end;
  auto edits = format(document);
  std::erase_if(edits, [&](const TextEdit& edit) {
    return edit.range.end < first || edit.range.begin > last;
  });
  return edits;
}

std::vector<TextEdit> formatTyped(const Document& document, Offset caret, char typed) {
  if (inCommentOrString(document, caret)) return {};
  if (typed == '\n') return newLine(document, caret);
  if (typed == ')') return closedDefinition(document, caret);
  return {};
}

std::vector<TextEdit> formatLines(const Document& document, std::span<const std::uint32_t> lines) {
  LineEdits typed(document);
  for (auto number : lines) typed.leave(number);
  return typed.edits;
}

bool sameTokens(const Document& a, const Document& b) {
  const auto same = [&](Spaces spaces) { return tokensOf(a, spaces) == tokensOf(b, spaces); };
  if (same(Spaces::BetweenWords)) return true;
  // some words end where another begins, with or without space: `0-` is two words
  return same(Spaces::None) && wordsOf(a) == wordsOf(b);
}

} // namespace proskill::syntax
