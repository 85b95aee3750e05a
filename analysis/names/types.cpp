#include "analysis/names/types.h"

#include <algorithm>
#include <array>
#include <utility>

namespace proskill::analysis {

namespace {

struct BasicType {
  std::string_view word;
  TypeKind kind;
};

constexpr std::array kBasicTypes = {
    BasicType{"nat", TypeKind::Natural}, BasicType{"int", TypeKind::Integer},
    BasicType{"float", TypeKind::Float}, BasicType{"bool", TypeKind::Boolean},
    BasicType{"string", TypeKind::String}};

constexpr auto kBasicTypeWords = [] {
  std::array<std::string_view, kBasicTypes.size()> names;
  std::ranges::transform(kBasicTypes, names.begin(), &BasicType::word);
  return names;
}();

constexpr std::array<std::string_view, 5> kStatusWords = {"no_status", "success", "failure",
                                                          "failed_inv", "interrupted"};

} // namespace

std::span<const std::string_view> statusWords() { return kStatusWords; }
std::span<const std::string_view> basicTypeWords() { return kBasicTypeWords; }

Type typeOfVariable(const Program& program, const SymbolTable& symbols, SymbolId variable) {
  const auto& definition = program.stateVariables.all[symbols[variable].definition];
  if (!definition->states.empty()) return {TypeKind::Value, variable};
  return definition->isNatural() ? Type{TypeKind::Natural, variable} : Type{};
}

Type typeNamed(const Program& program, const SymbolTable& symbols, std::string_view name) {
  auto basic = std::ranges::find(kBasicTypes, name, &BasicType::word);
  if (basic != kBasicTypes.end()) return {basic->kind, kNoSymbol};
  const SymbolId variable = symbols.find(SymbolKind::StateVariable, name);
  return variable == kNoSymbol ? Type{} : typeOfVariable(program, symbols, variable);
}

bool isTruthValue(const syntax::Input& input) {
  const auto* basic = std::ranges::find(kBasicTypes, input.type.text, &BasicType::word);
  return basic != kBasicTypes.end() && basic->kind == TypeKind::Boolean;
}

Type typeOfNumber(const syntax::Expr& number) {
  if (number.decimal) return {TypeKind::Float, kNoSymbol};
  return {number.number.numerator < 0 ? TypeKind::Integer : TypeKind::Natural, kNoSymbol};
}

bool isNumber(TypeKind kind) {
  return kind == TypeKind::Natural || kind == TypeKind::Integer || kind == TypeKind::Float;
}

bool fits(Type given, Type wanted) {
  if (!given.known() || !wanted.known() || given == wanted) return true;
  if (wanted.of != kNoSymbol) return false;
  return isNumber(given.kind) && isNumber(wanted.kind) && given.kind <= wanted.kind;
}

bool comparable(Type a, Type b) {
  if (!a.known() || !b.known()) return true;
  if (a.kind != b.kind) return false;
  switch (a.kind) {
  case TypeKind::Natural:
  case TypeKind::Status:
  case TypeKind::Result: return true;
  case TypeKind::Value: return a.of == b.of;
  case TypeKind::Unknown:
  case TypeKind::Boolean:
  case TypeKind::Integer:
  case TypeKind::Float:
  case TypeKind::String: return false;
  }
  std::unreachable();
}

std::string describe(Type type, const SymbolTable& symbols) {
  const std::string of = type.of == kNoSymbol ? "" : "`" + std::string(symbols[type.of].name) + "`";
  switch (type.kind) {
  case TypeKind::Unknown: return "nothing known";
  case TypeKind::Boolean: return "a truth value";
  case TypeKind::Natural: return of.empty() ? "a natural" : "a value of " + of;
  case TypeKind::Integer: return "an integer";
  case TypeKind::Float: return "a decimal number";
  case TypeKind::String: return "a string";
  case TypeKind::Value: return "a value of " + of;
  case TypeKind::Status: return "a status";
  case TypeKind::Result: return "a result of " + of;
  }
  return {};
}

} // namespace proskill::analysis
