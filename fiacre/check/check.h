#pragma once

#include "fiacre/syntax/tree.h"

#include <string>
#include <vector>

namespace proskill::fiacre {

/// Something that a Fiacre compiler would refuse, or that would fail whenever it ran.
struct Problem {
  std::string place;   ///< in words: "process skill_takeoff, state run"
  std::string message; ///< "`battery` is not declared"
  OriginId origin = 0;
};

/// What is wrong with a model, in the order of its text; nothing where frac would take it.
/// Names (declared once, used as what they are, none reserved), types of all expressions, states,
/// paths (each ends in one `to` or `loop`, waits once at most and only where it is silent,
/// communicates once at most), instances, intervals, and the paths that properties name. The trees'
/// own shape (an `if` has a condition) is taken for granted.
[[nodiscard]] std::vector<Problem> check(const Program& program);

} // namespace proskill::fiacre
