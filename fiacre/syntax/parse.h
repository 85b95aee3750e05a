#pragma once

#include "fiacre/syntax/lexer.h"
#include "fiacre/syntax/tree.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::fiacre {

/// What a name is, where the grammar says so.
enum class NameKind : std::uint8_t {
  Constant,
  Type,
  Channel,
  Event,
  Task,
  Extern,
  Function,
  Process, ///< in a composition a component, too
  Component,
  Property,
  State,
  Variable,
  Parameter,
  Port,
  Field,
  Constructor,
  Tag,
  Value,   ///< in an expression or at the begin of a statement: whatever has that name
  Foreign, ///< a function of C
};

/// A name in a text.
struct Mention {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  NameKind kind = NameKind::Value;
  bool declares = false; ///< here it gets its meaning
  /// Where a path leads, in which the name is looked for: an index into `Parsed::paths`. 0: no
  /// path.
  std::uint32_t path = 0;
};

/// A declaration with all that belongs to it.
struct Block {
  NameKind kind = NameKind::Process;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// Of a property or a probe: the name that it begins with, and places in `par`.
struct PathTaken {
  std::string begins;
  std::vector<std::uint32_t> places;
};

/// A text of Fiacre or H-Fiacre as a tree. Origins are the text's own ranges: `actor` is the
/// process, `words` the statement on one line.
struct Parsed {
  Program program;
  Provenance provenance;
  std::vector<Mention> mentions; ///< in the order of the text, of what could be read
  std::vector<Block> blocks; ///< in the order of the text; one that cannot be read goes to the next
  std::vector<PathTaken> paths{1};
  std::vector<SyntaxProblem> problems; ///< in the order of the text; none: nothing was left out
};

/// Places in the `par` of the model, by names.
using PathSteps = std::map<std::string, std::uint32_t, std::less<>>;

/// Never fails: what cannot be read is a problem, and reading goes on at the next `from`,
/// declaration or property. Constants in types and in bounds of time are put in as numbers;
/// comments and names of channels are not kept.
/// Berthomieu et al., "The syntax and semantics of Fiacre" (V2, V3).
/// \param steps names that paths may have in the place of numbers
[[nodiscard]] Parsed parse(std::string_view text, const PathSteps& steps = {});

/// One expression, all of the text; nothing where it is none.
[[nodiscard]] std::optional<Expr> parseExpr(std::string_view text);

} // namespace proskill::fiacre
