#pragma once

#include "fiacre/check/declarations.h"

#include <map>
#include <optional>
#include <string_view>

namespace proskill::fiacre {

struct Symbol {
  Type type;
  bool writable = true;
};

/// The variables and parameters visible to an expression.
using Scope = std::map<std::string_view, Symbol>;

/// The type with type names replaced, except names of records and unions.
[[nodiscard]] Type canonical(const Type& type, const Declarations& declarations);
/// Whether types are equal: records and unions by name. Variables passed by reference require this.
[[nodiscard]] bool sameType(const Type& a, const Type& b, const Declarations& declarations);

/// Infers the types of expressions. Numbers of all types are compatible, as in Fiacre with
/// coercions. A constant outside of the type that it is assigned to is a problem.
class Typing {
public:
  Typing(const Declarations& known, const Scope& visible, Report to)
      : declarations(&known), scope(&visible), report(std::move(to)) {}

  /// Reports an expression that does not have the type.
  void expect(const Expr& expr, const Type& type) const;
  void expectBool(const Expr& expr) const { expect(expr, Type{}); }
  void expectAll(const std::vector<Expr>& exprs, const std::vector<Type>& types,
                 std::string_view what) const;
  /// The type of an lvalue; reports expressions that cannot be assigned to.
  [[nodiscard]] std::optional<Type> target(const Expr& lvalue) const;
  /// Nothing if it has no type; this has been reported.
  [[nodiscard]] std::optional<Type> infer(const Expr& expr) const;

private:
  [[nodiscard]] std::optional<Type> inferName(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> inferConstruct(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> inferUnary(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> inferBinary(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> inferIndex(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> inferField(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> inferArray(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> inferRecord(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> inferQueue(const Expr& expr) const;
  void expectEqualTypes(const Expr& expr) const;
  void expectNumber(const Expr& expr) const;
  bool expectParts(const Expr& expr, const Type& type) const;
  void expectRecord(const Expr& expr, const Type& type) const;
  void expectInRange(const Expr& expr, const Type& type) const;
  [[nodiscard]] std::optional<std::int64_t> constant(const Expr& expr) const;
  [[nodiscard]] std::optional<Type> queueOf(const Expr& expr) const;
  /// The record or union with a canonical type's name.
  [[nodiscard]] const Type& structure(const Type& type) const;

  const Declarations* declarations;
  const Scope* scope;
  Report report;
};

/// Checks that every part of a type is declared and no range or array is empty.
void checkType(const Type& type, const Declarations& declarations, const Report& report);

} // namespace proskill::fiacre
