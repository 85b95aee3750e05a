#pragma once

#include "fiacre/syntax/tree.h"

#include <cstdint>
#include <string>
#include <vector>

namespace proskill::fiacre {

struct PrintOptions {
  bool prove = false; ///< print `prove NAME` below each property instead of the older `assert NAME`
};

/// Lines of a printed model that come from one place of the program, counted from 0, both included.
struct PrintedRange {
  OriginId origin = 0;
  std::uint32_t firstLine = 0;
  std::uint32_t lastLine = 0;
};

/// The text of a model and the origins of its lines; outer ranges come before inner ones.
struct PrintResult {
  std::string text;
  std::vector<PrintedRange> ranges;
};

/// A model as readable text that frac accepts. Compound expressions are in parentheses, and times
/// are naturals. Nothing of the tree is omitted: parts that Fiacre cannot express become comments.
[[nodiscard]] PrintResult printWithRanges(const Program& program, const PrintOptions& options = {});
[[nodiscard]] std::string print(const Program& program, const PrintOptions& options = {});

/// On one line, of any length.
[[nodiscard]] std::string printExpr(const Expr& expr);
/// An expression that can be assigned to: `skill[takeoff].status`.
[[nodiscard]] std::string printLvalue(const Expr& lvalue);
[[nodiscard]] std::string printType(const Type& type);
[[nodiscard]] std::string printInterval(const Interval& interval);
/// \param main the component at which the paths of observables start
[[nodiscard]] std::string printPattern(const Pattern& pattern, const std::string& main);

} // namespace proskill::fiacre
