#pragma once

#include "fiacre/syntax/tree.h"

#include <cstdint>
#include <string>
#include <vector>

namespace proskill::fiacre {

struct PrintOptions {
  bool prove = false; ///< `prove NAME` under each property, where `assert NAME` is older
};

/// Lines of a printed model that come from one place of the program. Counted from 0, both ends
/// within.
struct PrintedRange {
  OriginId origin = 0;
  std::uint32_t firstLine = 0;
  std::uint32_t lastLine = 0;
};

/// The text of a model, and where its lines come from: outer ranges before those within them.
struct PrintResult {
  std::string text;
  std::vector<PrintedRange> ranges;
};

/// A model as people read it and as frac takes it. Everything compound is in parentheses, times are
/// naturals, nothing of the tree is left out: what Fiacre has no words for is a comment.
[[nodiscard]] PrintResult printWithRanges(const Program& program, const PrintOptions& options = {});
[[nodiscard]] std::string print(const Program& program, const PrintOptions& options = {});

/// One line, however long.
[[nodiscard]] std::string printExpr(const Expr& expr);
/// What can be assigned to: `skill[takeoff].status`.
[[nodiscard]] std::string printLvalue(const Expr& lvalue);
[[nodiscard]] std::string printType(const Type& type);
[[nodiscard]] std::string printInterval(const Interval& interval);
/// `main` is the component from which the observables' paths start.
[[nodiscard]] std::string printPattern(const Pattern& pattern, const std::string& main);

} // namespace proskill::fiacre
