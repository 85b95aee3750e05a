#pragma once

#include "fiacre/syntax/tree.h"

#include <string>
#include <vector>

namespace proskill::fiacre {

/// An error: something that a Fiacre compiler would reject, or that would fail in every run.
struct Problem {
  std::string place;   ///< description: "process skill_takeoff, state run"
  std::string message; ///< "`battery` is not declared"
  OriginId origin = 0;
};

/// Checks a model and returns its problems in the order of the text; none if frac would accept it.
/// Checks names (declared once, used according to their kind, not reserved), types of all
/// expressions, states, paths (each ends with one `to` or `loop`, waits at most once and only if it
/// is silent, communicates at most once), instances, intervals, and paths in properties. It assumes
/// that the trees are well-formed (for example that an `if` has a condition).
[[nodiscard]] std::vector<Problem> check(const Program& program);

} // namespace proskill::fiacre
