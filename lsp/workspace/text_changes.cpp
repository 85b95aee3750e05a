#include "lsp/workspace/text_changes.h"

#include "syntax/text/utf8.h"

#include <string>
#include <utility>

namespace proskill::lsp {

namespace {

/// In bytes. Changes farther apart are separate edits.
constexpr std::size_t kTogether = 4096;
/// Beyond this number of edits, parsing a long text again is faster.
constexpr unsigned kMostEdits = 16;

/// Whether the change replaces the whole text.
bool isWhole(const Json& change) { return !change.contains("range"); }

std::optional<syntax::EditorPosition> editorPosition(const Json& json) {
  const Json& line = rpc::memberAt(json, {"line"});
  const Json& character = rpc::memberAt(json, {"character"});
  if (!line.is_number_unsigned() || !character.is_number_unsigned()) return std::nullopt;
  return syntax::EditorPosition{line.get<std::uint32_t>(), character.get<std::uint32_t>()};
}

/// The range of bytes that a change replaces, and the new text.
struct Replacement {
  syntax::Range range;
  std::string text;
};

/// If a position splits a character of two units: the number of its bytes; otherwise 0.
std::size_t cutAt(std::string_view text, const syntax::LineIndex& lines, syntax::Offset at,
                  syntax::EditorPosition position, syntax::Encoding encoding) {
  if (encoding != syntax::Encoding::Utf16) return 0;
  const auto length = syntax::sequenceLength(text.substr(at));
  const auto before = syntax::toEditor(text, lines, at, encoding);
  const bool isWithin = before.line == position.line && before.character + 1 == position.character;
  return length == 4 && isWithin ? length : 0;
}

/// \return nullopt if the range is outside the text. Half a character that remains becomes U+FFFD,
/// which also has one unit.
std::optional<Replacement> replacementIn(std::string_view text, const syntax::LineIndex& lines,
                                         const Json& range, std::string_view inserted,
                                         syntax::Encoding encoding) {
  const auto start = editorPosition(rpc::memberAt(range, {"start"}));
  const auto end = editorPosition(rpc::memberAt(range, {"end"}));
  if (!start || !end || *end < *start || end->line > lines.lineCount()) return std::nullopt;
  Replacement result{{syntax::fromEditor(text, lines, *start, encoding),
                      syntax::fromEditor(text, lines, *end, encoding)},
                     std::string(inserted)};
  if (cutAt(text, lines, result.range.begin, *start, encoding) > 0)
    result.text.insert(0, syntax::kReplacement);
  if (const auto cut = cutAt(text, lines, result.range.end, *end, encoding)) {
    result.range.end += static_cast<syntax::Offset>(cut);
    result.text += syntax::kReplacement;
  }
  return result;
}

/// A document, and a text that differs from it in one region.
class Edited {
public:
  explicit Edited(syntax::Document from) : document(std::move(from)), text(document.text()) {}

  bool apply(const Json& change, syntax::Encoding encoding) {
    const Json& words = rpc::memberAt(change, {"text"});
    if (!words.is_string()) return false;
    const auto& inserted = words.get_ref<const std::string&>();
    if (isWhole(change)) {
      replace({0, static_cast<syntax::Offset>(text.size())}, inserted);
      return true;
    }
    const syntax::LineIndex lines(text);
    const auto made = replacementIn(text, lines, change["range"], inserted, encoding);
    if (!made) return false;
    if (dirty && edits < kMostEdits && isFar(made->range)) parse();
    replace(made->range, made->text);
    return true;
  }

  syntax::Document parsed() && {
    parse();
    return std::move(document);
  }

private:
  [[nodiscard]] bool isFar(syntax::Range range) const {
    return range.begin > now.end + kTogether || range.end + kTogether < now.begin;
  }

  void replace(syntax::Range range, std::string_view inserted) {
    if (!dirty) now = before = range;
    dirty = true;
    if (range.begin < now.begin) {
      before.begin -= now.begin - range.begin;
      now.begin = range.begin;
    }
    if (range.end > now.end) {
      before.end += range.end - now.end;
      now.end = range.end;
    }
    now.end += static_cast<syntax::Offset>(inserted.size());
    now.end -= range.end - range.begin;
    text.replace(range.begin, range.end - range.begin, inserted);
  }

  void parse() {
    if (!dirty) return;
    const bool whole = before.begin == 0 && before.end == document.text().size();
    document = whole ? syntax::Document::parse(text)
                     : document.edit(before,
                                     std::string_view(text).substr(now.begin, now.end - now.begin));
    dirty = false;
    ++edits;
  }

  syntax::Document document;
  std::string text;
  bool dirty = false;
  syntax::Range before; ///< the region in the document
  syntax::Range now;    ///< in the text
  unsigned edits = 0;
};

/// The usual case when typing, without a copy of the text.
std::optional<syntax::Document> changedOnce(const syntax::Document& document, const Json& change,
                                            syntax::Encoding encoding) {
  const Json& words = rpc::memberAt(change, {"text"});
  if (!words.is_string()) return std::nullopt;
  const auto& inserted = words.get_ref<const std::string&>();
  if (isWhole(change)) return syntax::Document::parse(inserted);
  const auto made =
      replacementIn(document.text(), document.lines(), change["range"], inserted, encoding);
  if (!made) return std::nullopt;
  return document.edit(made->range, made->text);
}

/// The last change that replaces the whole text; earlier ones do not matter.
Json::const_iterator firstThatCounts(const Json& changes) {
  auto it = changes.end();
  while (it != changes.begin())
    if (isWhole(*--it) && rpc::memberAt(*it, {"text"}).is_string()) return it;
  return changes.begin();
}

} // namespace

bool replaceWhole(const Json& changes) {
  if (!changes.is_array() || changes.empty()) return false;
  const auto& first = *firstThatCounts(changes);
  return isWhole(first) && rpc::memberAt(first, {"text"}).is_string();
}

std::optional<syntax::Document> changed(syntax::Document document, const Json& changes,
                                        syntax::Encoding encoding) {
  if (!changes.is_array()) return std::nullopt;
  const auto first = firstThatCounts(changes);
  const auto count = changes.end() - first;
  if (count == 0) return document;
  if (count == 1) return changedOnce(document, *first, encoding);
  Edited edited(std::move(document));
  for (auto change = first; change != changes.end(); ++change)
    if (!edited.apply(*change, encoding)) return std::nullopt;
  return std::move(edited).parsed();
}

} // namespace proskill::lsp
