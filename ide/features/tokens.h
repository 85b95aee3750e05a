#pragma once

#include "ide/snapshot/snapshot.h"

#include <cstdint>
#include <span>
#include <vector>

/// What each word of a text is, for an editor that colours by meaning.
namespace proskill::ide {

/// In the order of the legend that clients are told; new ones are added at the end.
enum class TokenType : std::uint8_t {
  Keyword, // `defskill`, `if`, `and`
  Field,   // `:init`
  Comment,
  String,
  Number,
  Operator, // `=`, `^`, `//`
  Skill,
  Variable,
  Value, // of a state variable
  Event,
  Parameter,
  Type, // of an input
  Resource,
  Property,
  Environment,
  Tag,
  Label,
};

/// Bits of a set.
enum TokenModifier : std::uint8_t {
  kDefinition = 1,
  kWritten = 2, ///< a state variable is set
  kUnused = 4,  ///< the definition of what nothing else mentions
};

struct Token {
  syntax::Range range; ///< within one line
  TokenType type = TokenType::Keyword;
  std::uint8_t modifiers = 0;

  friend bool operator==(const Token&, const Token&) = default;
};

/// In the order of the text; those that touch `within`.
[[nodiscard]] std::vector<Token> tokens(const View& view, syntax::Range within);
[[nodiscard]] std::vector<Token> tokens(const View& view);

/// The names that begin in a range, in their order: all that the tokens of a region of a program
/// depend on beside its own text.
[[nodiscard]] std::vector<Token> nameTokens(const View& view, syntax::Range within);
/// The tokens of a region of the view's document.
/// \param names of the region's range
[[nodiscard]] std::vector<Token> tokens(const View& view, const syntax::Region& region,
                                        std::span<const Token> names);

} // namespace proskill::ide
