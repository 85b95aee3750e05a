#pragma once

#include "syntax/text/source.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace proskill::ide {

enum class FoldKind : std::uint8_t { Form, Comment };

/// Lines that can be folded into the first one.
struct Fold {
  std::uint32_t firstLine = 0;
  std::uint32_t lastLine = 0; ///< > firstLine
  FoldKind kind = FoldKind::Form;

  friend bool operator==(const Fold&, const Fold&) = default;
};

/// Folds by first line; of two that begin on one line, the longer is kept.
class FoldList {
public:
  explicit FoldList(const syntax::LineIndex& lines) : lines(lines) {}

  void add(syntax::Range range, FoldKind kind = FoldKind::Form) {
    const auto first = lines.position(range.begin, near).line;
    auto lineOfEnd = first;
    const auto last = lines.position(range.end, lineOfEnd).line;
    if (last > first) folds.push_back({first, last, kind});
  }

  [[nodiscard]] std::vector<Fold> take() {
    std::ranges::stable_sort(folds, [](const Fold& a, const Fold& b) {
      return a.firstLine != b.firstLine ? a.firstLine < b.firstLine : a.lastLine > b.lastLine;
    });
    const auto shorter = std::ranges::unique(folds, {}, &Fold::firstLine);
    folds.erase(shorter.begin(), shorter.end());
    return std::move(folds);
  }

private:
  const syntax::LineIndex& lines;
  std::uint32_t near = 0; ///< the line of the last fold
  std::vector<Fold> folds;
};

} // namespace proskill::ide
