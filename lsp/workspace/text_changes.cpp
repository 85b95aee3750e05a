#include "lsp/workspace/text_changes.h"

#include "syntax/text/utf8.h"

#include <string>
#include <utility>

namespace proskill::lsp {

namespace {

/// Changes farther apart than this, in bytes, are edits of their own.
constexpr std::size_t kTogether = 4096;
/// So many edits cost what it costs to parse a long text anew.
constexpr unsigned kMostEdits = 16;

/// Whether it gives the text as a whole.
bool isWhole(const Json& change) { return !change.contains("range"); }

std::optional<syntax::EditorPosition> editorPosition(const Json& json) {
  const Json& line = rpc::memberAt(json, {"line"});
  const Json& character = rpc::memberAt(json, {"character"});
  if (!line.is_number_unsigned() || !character.is_number_unsigned()) return std::nullopt;
  return syntax::EditorPosition{line.get<std::uint32_t>(), character.get<std::uint32_t>()};
}

/// The bytes that a change replaces, and what they become.
struct Replacement {
  syntax::Range range;
  std::string text;
};

/// The character of two units that a place cuts in two: its bytes, or 0 where it cuts none.
std::size_t cutAt(std::string_view text, const syntax::LineIndex& lines, syntax::Offset at,
                  syntax::EditorPosition position, syntax::Encoding encoding) {
  if (encoding != syntax::Encoding::Utf16) return 0;
  const auto length = syntax::sequenceLength(text.substr(at));
  const auto before = syntax::toEditor(text, lines, at, encoding);
  const bool isWithin = before.line == position.line && before.character + 1 == position.character;
  return length == 4 && isWithin ? length : 0;
}

/// Nothing where the range is none of the text. Half a character that stays becomes U+FFFD, of one
/// unit as it was.
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

/// A document, and a text that differs from its own in one region.
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

/// What typing sends, and so without a second text.
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

/// The last change that gives the whole text heals whatever was wrong before it.
Json::const_iterator firstThatCounts(const Json& changes) {
  auto it = changes.end();
  while (it != changes.begin())
    if (isWhole(*--it) && rpc::memberAt(*it, {"text"}).is_string()) return it;
  return changes.begin();
}

} // namespace

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
