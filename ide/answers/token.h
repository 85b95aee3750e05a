#pragma once

#include "syntax/text/source.h"

#include <cstdint>

namespace proskill::ide {

/// In the order of the legend sent to clients. Add new types at the end.
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

/// Bits of a set of modifiers.
enum TokenModifier : std::uint8_t {
  kDefinition = 1,
  kWritten = 2, ///< sets a state variable
  kUnused = 4,  ///< a definition that nothing else mentions
};

struct Token {
  syntax::Range range; ///< within one line
  TokenType type = TokenType::Keyword;
  std::uint8_t modifiers = 0;

  friend bool operator==(const Token&, const Token&) = default;
};

} // namespace proskill::ide
