#pragma once

#include "analysis/names/symbols.h"

#include <cstdint>
#include <string>

namespace proskill::analysis {

enum class TypeKind : std::uint8_t {
  Unknown, ///< of what is wrong or missing; it fits everywhere, so that one mistake is told once
  Boolean,
  Natural,
  Integer,
  Float,
  String,
  Value,  ///< of the enumeration `of`
  Status, ///< of a skill
  Result, ///< an outcome's tag of the skill `of`
};

struct Type {
  TypeKind kind = TypeKind::Unknown;
  SymbolId of = kNoSymbol; ///< Value: its state variable; Natural: likewise, where it is of one

  [[nodiscard]] bool known() const { return kind != TypeKind::Unknown; }
  friend bool operator==(const Type&, const Type&) = default;
};

/// The words that `skill.status` can be compared with.
[[nodiscard]] std::span<const std::string_view> statusWords();
/// What `skill.res` is before the skill has ended for the first time.
constexpr std::string_view kNoResult = "no_result";
/// The types of inputs that are not state variables.
[[nodiscard]] std::span<const std::string_view> basicTypeWords();

/// \pre `variable` is a state variable.
[[nodiscard]] Type typeOfVariable(const Program& program, const SymbolTable& symbols,
                                  SymbolId variable);
/// Of an input's type: `float`, `battery`. Unknown where there is no such type.
[[nodiscard]] Type typeNamed(const Program& program, const SymbolTable& symbols,
                             std::string_view name);
/// Of a number as written: the narrowest.
[[nodiscard]] Type typeOfNumber(const syntax::Expr& number);

/// A value of `given` can be passed where `wanted` is declared: naturals are integers, integers are
/// floats.
[[nodiscard]] bool fits(Type given, Type wanted);
/// `=` makes sense between them.
[[nodiscard]] bool comparable(Type a, Type b);
/// With its article: "a value of `battery`".
[[nodiscard]] std::string describe(Type type, const SymbolTable& symbols);

} // namespace proskill::analysis
