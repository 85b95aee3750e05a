#include "syntax/document.h"

#include "syntax/change.h"
#include "syntax/codes.h"
#include "syntax/region.h"
#include "syntax/scan.h"
#include "syntax/shift.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <span>

namespace proskill::syntax {
namespace {

/// A region's place in a document, and how many of its forms, comments, and diagnostics are its
/// own.
struct Piece {
  Range range;
  std::shared_ptr<const ParsedText> parsed;
  std::size_t forms = 0;
  std::size_t comments = 0;
  std::size_t diagnostics = 0;
};

/// Where a piece's share begins.
struct Shares {
  std::size_t forms = 0;
  std::size_t comments = 0;
  std::size_t diagnostics = 0;

  void pass(const Piece& piece) {
    forms += piece.forms;
    comments += piece.comments;
    diagnostics += piece.diagnostics;
  }
};

void shift(Range& range, Offset by) {
  range.begin += by;
  range.end += by;
}

/// Copies or moves `count` items from `from`, moved `by` bytes.
template <class Iterator, class Item>
void append(Iterator from, std::size_t count, Offset by, std::vector<Item>& to) {
  for (std::size_t i = 0; i < count; ++i, ++from) shift(to.emplace_back(*from), by);
}

} // namespace

struct Document::State {
  std::pmr::monotonic_buffer_resource arena; ///< of the forms
  std::string text;
  LineIndex lines;
  std::vector<Piece> pieces;
  std::vector<Form> forms;
  std::vector<Range> comments;
  std::vector<Diagnostic> diagnostics;

  explicit State(std::string source) : text(std::move(source)), lines(text) {}

  [[nodiscard]] std::string_view textOf(Range range) const {
    return std::string_view(text).substr(range.begin, range.length());
  }

  /// Reads what stands in `ranges`, which follow each other.
  void read(std::span<const Range> ranges) {
    std::vector<std::string_view> texts;
    for (Range range : ranges) texts.push_back(textOf(range));
    auto regions = readRegions(texts);
    for (std::size_t i = 0; i < ranges.size(); ++i) add(ranges[i], std::move(regions[i]));
  }

  /// Where a piece begins; the end of the text for what is behind the last one.
  [[nodiscard]] Offset beginOf(std::size_t piece) const {
    return piece < pieces.size() ? pieces[piece].range.begin : static_cast<Offset>(text.size());
  }

  /// Whether what stands there is what was read: nothing was put in or left out.
  [[nodiscard]] bool isReadAsIs(const Piece& piece) const {
    return !piece.parsed->mended && piece.parsed->text == textOf(piece.range);
  }
  [[nodiscard]] bool isWithoutMistake(const Piece& piece) const {
    return piece.diagnostics == 0 && isReadAsIs(piece);
  }

  /// Makes room for what an edit of the other document leaves of it, and a bit.
  void reserveAs(const State& other) {
    constexpr std::size_t kMore = 16;
    pieces.reserve(other.pieces.size() + kMore);
    forms.reserve(other.forms.size() + kMore);
    comments.reserve(other.comments.size() + kMore);
    diagnostics.reserve(other.diagnostics.size() + kMore);
  }

  void add(Range range, Region region) {
    pieces.push_back({range, region.parsed, region.forms.size(), region.comments.size(),
                      region.diagnostics.size()});
    append(std::make_move_iterator(region.forms.begin()), region.forms.size(), range.begin, forms);
    append(region.comments.begin(), region.comments.size(), range.begin, comments);
    append(std::make_move_iterator(region.diagnostics.begin()), region.diagnostics.size(),
           range.begin, diagnostics);
  }

  /// Takes a piece over from another document, in which its shares begin at `shares`.
  void reuse(const State& other, const Piece& piece, const Shares& shares, Range range) {
    Offset by = range.begin - piece.range.begin; // may wrap around, and back when it is added
    pieces.push_back(piece);
    pieces.back().range = range;
    append(other.forms.begin() + static_cast<long>(shares.forms), piece.forms, by, forms);
    append(other.comments.begin() + static_cast<long>(shares.comments), piece.comments, by,
           comments);
    append(other.diagnostics.begin() + static_cast<long>(shares.diagnostics), piece.diagnostics, by,
           diagnostics);
  }

  /// Gives each form the comment that ends in the line above it.
  void attachComments() {
    auto comment = comments.begin();
    for (Form& form : forms) {
      while (comment != comments.end() && comment->end <= form.range.begin) ++comment;
      form.comment = commentAbove(form.range.begin, comment);
    }
  }

  [[nodiscard]] Range commentAbove(Offset at, std::vector<Range>::const_iterator next) const {
    Range found;
    std::uint32_t line = lines.position(at).line;
    while (next != comments.begin()) {
      const Range& comment = *--next;
      Position place = lines.position(comment.begin);
      auto before = textOf({comment.begin - place.column, comment.begin});
      if (place.line + 1 != line || before.find_first_not_of(" \t") != std::string_view::npos)
        break;
      if (found.empty()) found.end = comment.end;
      found.begin = comment.begin;
      --line;
    }
    return found;
  }
};

Document Document::parse(std::string text) {
  Document document;
  bool tooLong = text.size() > kLongestText;
  auto state = std::make_shared<State>(tooLong ? std::string() : std::move(text));
  if (tooLong)
    state->diagnostics.push_back(makeDiagnostic(Code::TextTooLong, {}, kLongestRead >> 20));
  const ArenaScope inArena(state->arena);
  state->read(cut(state->text));
  state->attachComments();
  document.state = std::move(state);
  return document;
}

Document Document::edit(Range range, std::string_view text) const {
  assert(range.begin <= range.end && range.end <= state->text.size());
  std::string edited = state->text;
  edited.replace(range.begin, range.length(), text);
  if (edited.size() > kLongestText) return parse(std::move(edited));
  auto next = std::make_shared<State>(std::move(edited));
  const ArenaScope inArena(next->arena);
  next->reserveAs(*state);
  auto ranges = cut(next->text);
  const auto& pieces = state->pieces;
  auto same = [&](const Piece& piece, Range now) {
    return state->textOf(piece.range) == next->textOf(now);
  };
  auto [front, back] = commonEnds(pieces, ranges, same);

  Shares shares;
  for (std::size_t i = 0; i < front; ++i) {
    next->reuse(*state, pieces[i], shares, ranges[i]);
    shares.pass(pieces[i]);
  }
  next->read(std::span(ranges).subspan(front, ranges.size() - front - back));
  for (std::size_t i = front; i < pieces.size() - back; ++i) shares.pass(pieces[i]);
  for (std::size_t i = 0; i < back; ++i) {
    const Piece& piece = pieces[pieces.size() - back + i];
    next->reuse(*state, piece, shares, ranges[ranges.size() - back + i]);
    shares.pass(piece);
  }
  next->attachComments();
  Document document;
  document.state = std::move(next);
  return document;
}

const std::string& Document::text() const { return state->text; }
const LineIndex& Document::lines() const { return state->lines; }
const std::vector<Form>& Document::forms() const { return state->forms; }
std::span<const Form> Document::formsIn(Range range) const {
  auto from = [this](Offset at) {
    return std::ranges::lower_bound(state->forms, at, {},
                                    [](const Form& form) { return form.range.begin; });
  };
  return {from(range.begin), from(range.end)};
}

const std::vector<Range>& Document::comments() const { return state->comments; }
const std::vector<Diagnostic>& Document::diagnostics() const { return state->diagnostics; }

std::vector<Stretch> Document::stretches() const {
  std::vector<Stretch> result;
  result.reserve(state->pieces.size());
  for (const Piece& piece : state->pieces)
    result.push_back({piece.range, {piece.parsed, &piece.parsed->tree}, state->isReadAsIs(piece)});
  return result;
}

Change Document::changeFrom(const Document& before) const {
  const auto& old = before.state->pieces;
  const auto& now = state->pieces;
  auto [front, back] =
      commonEnds(old, now, [](const Piece& a, const Piece& b) { return a.parsed == b.parsed; });
  Change change;
  auto& stretches = change.stretches;
  stretches = {state->beginOf(front), before.state->beginOf(old.size() - back),
               state->beginOf(now.size() - back)};
  auto isRight = [front, back](const State& state) {
    const auto middle = std::span(state.pieces).first(state.pieces.size() - back).subspan(front);
    return std::ranges::all_of(middle, [&](const Piece& it) { return state.isWithoutMistake(it); });
  };
  if (!isRight(*before.state) || !isRight(*state)) return change;
  const auto oldText = before.state->textOf(stretches.before());
  const auto newText = state->textOf(stretches.after());
  auto edit = replacementOf(oldText, newText);
  if (!isLayout(oldText, newText, edit)) return change;
  for (Offset* at : {&edit.begin, &edit.oldEnd, &edit.newEnd}) *at += stretches.begin;
  change.layout = edit;
  return change;
}

std::string Document::dump() const {
  std::string out;
  for (const Piece& piece : state->pieces) {
    out += toString(piece.parsed->tree, piece.range.begin);
    out += '\n';
  }
  return out;
}

} // namespace proskill::syntax
