#pragma once

#include "analysis/names/symbols.h"

#include <cstdint>
#include <string>

namespace proskill::analysis {

enum class TypeKind : std::uint8_t {
  Unknown, ///< wrong or missing; fits everywhere, so that one error is reported once
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
  SymbolId of = kNoSymbol; ///< Value: its state variable; Natural: the same, if it is of one

  [[nodiscard]] bool known() const { return kind != TypeKind::Unknown; }
  friend bool operator==(const Type&, const Type&) = default;
};

/// The words that `skill.status` can be compared with.
[[nodiscard]] std::span<const std::string_view> statusWords();
/// The value of `skill.res` before the skill has ended for the first time.
constexpr std::string_view kNoResult = "no_result";
/// The types of inputs that are not state variables.
[[nodiscard]] std::span<const std::string_view> basicTypeWords();

/// \pre `variable` is a state variable
[[nodiscard]] Type typeOfVariable(const Program& program, const SymbolTable& symbols,
                                  SymbolId variable);
/// The type with this name: `float`, `battery`. Unknown if there is none.
[[nodiscard]] Type typeNamed(const Program& program, const SymbolTable& symbols,
                             std::string_view name);
/// Whether the input is a truth value, so that conditions can test it.
[[nodiscard]] bool isTruthValue(const syntax::Input& input);
/// The narrowest type of a number as written.
[[nodiscard]] Type typeOfNumber(const syntax::Expr& number);

[[nodiscard]] bool isNumber(TypeKind kind);
/// Whether a value of type `given` can be passed as `wanted`: naturals are integers, integers are
/// floats.
[[nodiscard]] bool fits(Type given, Type wanted);
/// Whether `=` can compare them.
[[nodiscard]] bool comparable(Type a, Type b);
/// With an article: "a value of `battery`".
[[nodiscard]] std::string describe(Type type, const SymbolTable& symbols);

} // namespace proskill::analysis
