#pragma once

#include "fiacre/lexer.h"
#include "fiacre/tree.h"

#include <string_view>
#include <vector>

namespace proskill::fiacre {

/// A text of Fiacre or H-Fiacre as a tree. Origins are the text's own ranges: `actor` is the
/// process, `words` the statement on one line.
struct Parsed {
  Program program;
  Provenance provenance;
  std::vector<SyntaxProblem> problems; ///< in the order of the text; none: nothing was left out
};

/// Never fails: what cannot be read is a problem, and reading goes on at the next `from`,
/// declaration or property. Constants in types and in bounds of time are put in as numbers;
/// comments and names of channels are not kept.
/// Berthomieu et al., "The syntax and semantics of Fiacre" (V2, V3).
[[nodiscard]] Parsed parse(std::string_view text);

/// One expression, all of the text; nothing where it is none.
[[nodiscard]] std::optional<Expr> parseExpr(std::string_view text);

} // namespace proskill::fiacre
