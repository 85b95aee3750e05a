#include "syntax/document.h"

#include "syntax/diagnostics/codes.h"
#include "syntax/region.h"
#include "syntax/text/change.h"
#include "syntax/text/scan.h"
#include "syntax/tree/shift.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <span>

namespace proskill::syntax {

/// A region with its position in a document.
struct PlacedRegion {
  Range range;
  std::shared_ptr<const ParsedRegion> content;
};

namespace {

std::size_t countOfForms(std::span<const PlacedRegion> regions) {
  std::size_t count = 0;
  for (const PlacedRegion& region : regions) count += region.content->forms.size();
  return count;
}

} // namespace

struct Document::State {
  std::string text;
  LineIndex lines;
  std::vector<PlacedRegion> regions;
  std::vector<Form> forms;
  std::vector<Range> comments;
  std::vector<Diagnostic> diagnostics;

  explicit State(std::string source) : text(std::move(source)), lines(text) {}
  State(std::string source, LineIndex lines) : text(std::move(source)), lines(std::move(lines)) {}

  [[nodiscard]] std::string_view textOf(Range range) const {
    return std::string_view(text).substr(range.begin, range.length());
  }

  /// Start of a region; the end of the text for the region after the last.
  [[nodiscard]] Offset beginOf(std::size_t region) const {
    return region < regions.size() ? regions[region].range.begin : static_cast<Offset>(text.size());
  }

  /// The numbers of regions before and after an edit that remain unchanged as far as lines show: a
  /// region begins with the first word of a line.
  [[nodiscard]] CommonEnds around(Range edit) const {
    const Offset line = edit.begin - lines.position(edit.begin).column;
    const auto end = [](const PlacedRegion& region) { return region.range.end; };
    const auto begin = [](const PlacedRegion& region) { return region.range.begin; };
    const auto front = std::ranges::lower_bound(regions, line, {}, end);
    const auto back = std::ranges::upper_bound(regions, edit.end, {}, begin);
    return {static_cast<std::size_t>(front - regions.begin()),
            static_cast<std::size_t>(regions.end() - back)};
  }

  /// Whether the region was parsed without recovery: no character was added or removed.
  [[nodiscard]] bool isReadAsIs(const PlacedRegion& region) const {
    const auto& parsed = *region.content->parsed;
    return !parsed.recovered && parsed.text == textOf(region.range);
  }
  [[nodiscard]] bool isWithoutMistake(const PlacedRegion& region) const {
    return region.content->diagnostics.empty() && isReadAsIs(region);
  }

  /// Reserves memory for what an edit of the other document keeps of it, and a little more.
  void reserveAs(const State& other) {
    constexpr std::size_t kMore = 16;
    regions.reserve(other.regions.size() + kMore);
    forms.reserve(other.forms.size() + kMore);
    comments.reserve(other.comments.size() + kMore);
    diagnostics.reserve(other.diagnostics.size() + kMore);
  }

  /// Parses the text in `ranges`, which are in order.
  void read(std::span<const Range> ranges) {
    std::vector<std::string_view> texts;
    for (Range range : ranges) texts.push_back(textOf(range));
    auto fresh = readRegions(texts);
    for (std::size_t i = 0; i < ranges.size(); ++i) read(ranges[i], std::move(fresh[i]));
  }
  void read(Range range, ParsedRegion fresh) {
    for (ReadForm& form : fresh.forms) shift(form, range.begin);
    const auto content = std::make_shared<const ParsedRegion>(std::move(fresh));
    for (const ReadForm& form : content->forms)
      forms.emplace_back(std::shared_ptr<const ReadForm>(content, &form));
    add(range, content);
  }

  /// Reuses regions of another document, whose forms begin at `form`.
  void reuse(const State& other, std::span<const PlacedRegion> those, std::size_t form, Offset by) {
    for (const auto& [range, content] : those) {
      for (const auto end = form + content->forms.size(); form != end; ++form)
        forms.push_back(other.forms[form].moved(by));
      add(range.moved(by), content);
    }
  }

  /// Adds everything of a region but its forms.
  void add(Range range, const std::shared_ptr<const ParsedRegion>& content) {
    regions.push_back({range, content});
    append(content->comments, range.begin, comments);
    append(content->diagnostics, range.begin, diagnostics);
  }
  template <class Item>
  static void append(const std::vector<Item>& from, Offset by, std::vector<Item>& to) {
    for (const Item& item : from) shift(to.emplace_back(item), by);
  }

  /// Gives each of these forms the comment that ends on the line above it.
  void attachComments(std::size_t begin, std::size_t end) {
    if (begin == end) return;
    auto comment = std::ranges::upper_bound(comments, forms[begin].range.begin, {}, &Range::end);
    for (std::size_t i = begin; i < end; ++i) {
      Form& form = forms[i];
      while (comment != comments.end() && comment->end <= form.range.begin) ++comment;
      form.comment = commentAbove(form.range.begin, comment);
    }
  }

  /// If several forms begin on a line, the first one has the comment.
  [[nodiscard]] Range commentAbove(Offset at, std::vector<Range>::const_iterator next) const {
    Range found;
    auto [line, column] = lines.position(at);
    if (textOf({at - column, at}).find_first_not_of(" \t") != std::string_view::npos) return found;
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
  state->read(cut(state->text));
  state->attachComments(0, state->forms.size());
  document.state = std::move(state);
  return document;
}

Document Document::edit(Range range, std::string_view text) const {
  assert(range.begin <= range.end && range.end <= state->text.size());
  const std::string_view old = state->text;
  std::string edited;
  edited.reserve(old.size() - range.length() + text.size());
  edited.append(old.substr(0, range.begin)).append(text).append(old.substr(range.end));
  if (edited.size() > kLongestText) return parse(std::move(edited));
  auto next = std::make_shared<State>(std::move(edited), state->lines.edited(range, text));
  const auto by = static_cast<Offset>(text.size()) - range.length(); // may wrap around
  next->reserveAs(*state);

  const std::span<const PlacedRegion> regions = state->regions;
  auto [front, back] = next->text.size() > kLongestRead ? CommonEnds() : state->around(range);
  const Range middle{state->beginOf(front), state->beginOf(regions.size() - back) + by};
  const auto cuts = cut(next->textOf(middle));
  const auto same = [&](const PlacedRegion& region, Range now) {
    return state->textOf(region.range) == next->textOf(now.moved(middle.begin));
  };
  const auto ends = commonEnds(regions.first(regions.size() - back).subspan(front), cuts, same);
  front += ends.front;
  back += ends.back;

  next->reuse(*state, regions.first(front), 0, 0);
  const auto firstRead = next->forms.size();
  std::vector<Range> ranges;
  for (Range each : std::span(cuts).first(cuts.size() - ends.back).subspan(ends.front))
    ranges.push_back(each.moved(middle.begin));
  next->read(ranges);
  const auto firstMoved = next->forms.size();
  next->reuse(*state, regions.last(back), state->forms.size() - countOfForms(regions.last(back)),
              by);
  // The comment above a form begins after the previous form. So among the reused forms, only the
  // first one after the edit may have a different comment.
  next->attachComments(firstRead, std::min(firstMoved + 1, next->forms.size()));
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

std::vector<Region> Document::regions() const {
  std::vector<Region> result;
  result.reserve(state->regions.size());
  for (const PlacedRegion& region : state->regions)
    result.push_back(
        {region.range, {region.content, &region.content->parsed->tree}, state->isReadAsIs(region)});
  return result;
}

Change Document::changeFrom(const Document& before) const {
  const auto& old = before.state->regions;
  const auto& now = state->regions;
  auto [front, back] = commonEnds(old, now, [](const PlacedRegion& a, const PlacedRegion& b) {
    return a.content == b.content;
  });
  Change change;
  auto& regions = change.regions;
  regions = {state->beginOf(front), before.state->beginOf(old.size() - back),
             state->beginOf(now.size() - back)};
  auto isRight = [front, back](const State& state) {
    const auto middle = std::span(state.regions).first(state.regions.size() - back).subspan(front);
    return std::ranges::all_of(middle,
                               [&](const PlacedRegion& it) { return state.isWithoutMistake(it); });
  };
  if (!isRight(*before.state) || !isRight(*state)) return change;
  const auto oldText = before.state->textOf(regions.before());
  const auto newText = state->textOf(regions.after());
  auto edit = replacementOf(oldText, newText);
  if (!isLayout(oldText, newText, edit)) return change;
  for (Offset* at : {&edit.begin, &edit.oldEnd, &edit.newEnd}) *at += regions.begin;
  change.layout = edit;
  return change;
}

std::string Document::dump() const {
  std::string out;
  for (const PlacedRegion& region : state->regions) {
    out += toString(region.content->parsed->tree, region.range.begin);
    out += '\n';
  }
  return out;
}

} // namespace proskill::syntax
