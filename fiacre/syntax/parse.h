#pragma once

#include "fiacre/syntax/lexer.h"
#include "fiacre/syntax/tree.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::fiacre {

/// The kind of a name, as far as the grammar determines it.
enum class NameKind : std::uint8_t {
  Constant,
  Type,
  Channel,
  Event,
  Task,
  Extern,
  Function,
  Process, ///< in a composition also a component
  Component,
  Property,
  State,
  Variable,
  Parameter,
  Port,
  Field,
  Constructor,
  Tag,
  Value,   ///< in an expression or at the beginning of a statement: anything with this name
  Foreign, ///< a function in C
};

/// A name in a text.
struct Mention {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  NameKind kind = NameKind::Value;
  bool declares = false; ///< this is its declaration
  /// The path in which the name is looked up, as an index into `Parsed::paths`; 0: none.
  std::uint32_t path = 0;
};

/// A declaration with everything that belongs to it.
struct Block {
  NameKind kind = NameKind::Process;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// The path of a property or a probe: the name with which it begins, then positions in `par`.
struct PathTaken {
  std::string begins;
  std::vector<std::uint32_t> places;
};

/// A Fiacre or H-Fiacre text as a tree. Origins are the text's own ranges: the actor is the
/// process, the description is the statement on one line.
struct Parsed {
  Program program;
  Provenance provenance;
  std::vector<Mention> mentions; ///< in the order of the text, as far as parsed
  /// In the order of the text; a block with a syntax error extends to the next one.
  std::vector<Block> blocks;
  std::vector<PathTaken> paths{1};
  std::vector<SyntaxProblem> problems; ///< in the order of the text; if empty, nothing was skipped
};

/// Positions in the `par` of the model, by name.
using PathSteps = std::map<std::string, std::uint32_t, std::less<>>;

/// Parses a text. Never fails: syntax errors are returned as problems, and parsing continues at the
/// next `from`, declaration or property. Constants in types and in bounds of time are replaced by
/// their values; comments and names of channels are dropped. Berthomieu et al., "The syntax and
/// semantics of Fiacre" (V2, V3).
/// \param steps names that paths may contain instead of numbers
[[nodiscard]] Parsed parse(std::string_view text, const PathSteps& steps = {});

/// Parses the whole text as one expression; nothing if it is not an expression.
[[nodiscard]] std::optional<Expr> parseExpr(std::string_view text);

} // namespace proskill::fiacre
