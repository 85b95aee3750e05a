#include "cli/output/unified_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace proskill::cli {

namespace {

constexpr std::uint32_t kContext = 3;

/// Lines of the old text that are replaced by new ones.
struct Change {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
  std::vector<syntax::TextEdit> edits;
};

std::vector<Change> changesOf(const syntax::Document& before,
                              std::span<const syntax::TextEdit> edits) {
  std::vector<Change> changes;
  for (const auto& edit : edits) {
    auto first = before.lines().position(edit.range.begin).line;
    auto end = before.lines().position(edit.range.end).line + 1;
    if (changes.empty() || changes.back().end < first) changes.push_back({first, end, {}});
    changes.back().end = std::max(changes.back().end, end);
    changes.back().edits.push_back(edit);
  }
  return changes;
}

class Diff {
public:
  explicit Diff(const syntax::Document& before) : before(before) {}

  /// Writes changes with common context as one hunk.
  void hunk(std::span<const Change> changes) {
    auto first = changes.front().first - std::min(changes.front().first, kContext);
    auto end = std::min(changes.back().end + kContext, lineCount());
    std::string body;
    std::uint32_t written = 0;
    auto line = first;
    for (const Change& change : changes) {
      written += lines(body, ' ', line, change.first);
      lines(body, '-', change.first, std::min(change.end, lineCount()));
      written += marked(body, '+', changed(change));
      line = change.end;
    }
    written += lines(body, ' ', line, end);
    text += fmt::format("@@ -{},{} +{},{} @@\n{}", first + 1, end - first, first + 1 + shift,
                        written, body);
    shift += static_cast<std::int64_t>(written) - (end - first);
  }

  std::string text;

private:
  /// Number of lines; the one after the last line end counts only if it is not empty.
  [[nodiscard]] std::uint32_t lineCount() const {
    return before.lines().lineCount() - (before.text().ends_with('\n') ? 1 : 0);
  }
  [[nodiscard]] syntax::Offset startOf(std::uint32_t line) const {
    return line < before.lines().lineCount() ? before.lines().offset({line, 0})
                                             : static_cast<syntax::Offset>(before.text().size());
  }
  [[nodiscard]] std::string_view between(std::uint32_t first, std::uint32_t end) const {
    auto begin = startOf(first);
    return std::string_view(before.text()).substr(begin, startOf(end) - begin);
  }

  static std::uint32_t marked(std::string& to, char mark, std::string_view some) {
    std::uint32_t count = 0;
    while (!some.empty()) {
      auto end = std::min(some.find('\n'), some.size() - 1) + 1;
      auto line = some.substr(0, end);
      to += mark;
      to += line;
      if (!line.ends_with('\n')) to += "\n\\ No newline at end of file\n";
      some.remove_prefix(end);
      ++count;
    }
    return count;
  }
  std::uint32_t lines(std::string& to, char mark, std::uint32_t first, std::uint32_t end) const {
    return first < end ? marked(to, mark, between(first, end)) : 0;
  }

  [[nodiscard]] std::string changed(const Change& change) const {
    auto edits = change.edits;
    auto begin = startOf(change.first);
    for (auto& edit : edits) {
      edit.range.begin -= begin;
      edit.range.end -= begin;
    }
    return syntax::applyEdits(between(change.first, change.end), edits);
  }

  const syntax::Document& before;
  std::int64_t shift = 0; ///< number of lines inserted so far
};

} // namespace

std::string unifiedDiff(const std::string& file, const syntax::Document& before,
                        std::span<const syntax::TextEdit> edits) {
  if (edits.empty()) return "";
  Diff diff(before);
  auto changes = changesOf(before, edits);
  for (std::size_t begin = 0, end = 1; begin < changes.size(); begin = end++) {
    while (end < changes.size() && changes[end].first <= changes[end - 1].end + 2 * kContext) ++end;
    diff.hunk(std::span(changes).subspan(begin, end - begin));
  }
  return fmt::format("--- {}\n+++ {}\n{}", file, file, diff.text);
}

} // namespace proskill::cli
