#pragma once

#include "syntax/text/source.h"

#include <cassert>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::test {

/// A program with marks: `^` is a point, `[[` and `]]` enclose a range. The `^` of a wait, between
/// a parenthesis and a space, is not a mark.
struct MarkedSource {
  std::string text; ///< without the marks
  std::vector<syntax::Offset> points;
  std::vector<syntax::Range> ranges; ///< in the order of their beginnings

  explicit MarkedSource(std::string_view marked) {
    std::vector<std::size_t> open;
    auto isWait = [&](std::size_t i) {
      return text.ends_with('(') && i + 1 < marked.size() && marked[i + 1] == ' ';
    };
    for (std::size_t i = 0; i < marked.size(); ++i) {
      auto two = marked.substr(i, 2);
      auto here = static_cast<syntax::Offset>(text.size());
      if (two == "[[" || two == "]]") {
        if (two == "[[") {
          open.push_back(ranges.size());
          ranges.push_back({here, here});
        } else {
          ranges[open.back()].end = here;
          open.pop_back();
        }
        ++i;
      } else if (marked[i] == '^' && !isWait(i)) {
        points.push_back(here);
      } else {
        text += marked[i];
      }
    }
  }

  /// A source with one mark.
  [[nodiscard]] syntax::Offset point() const {
    assert(points.size() == 1);
    return points.front();
  }
  [[nodiscard]] syntax::Range range() const {
    assert(ranges.size() == 1);
    return ranges.front();
  }
};

} // namespace proskill::test
