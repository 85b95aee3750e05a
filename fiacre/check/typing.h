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

/// The variables and parameters that an expression may name.
using Scope = std::map<std::string_view, Symbol>;

/// The type that a type stands for: names of records and unions stay, all others are replaced.
[[nodiscard]] Type canonical(const Type& type, const Declarations& declarations);
/// Records and unions are the same when their names are; a variable passed by reference needs this.
[[nodiscard]] bool sameType(const Type& a, const Type& b, const Declarations& declarations);

/// The types of expressions. Numbers of every type go together, as they do in Fiacre with
/// coercions; a constant that is outside of the type that it goes to is a problem.
class Typing {
public:
  Typing(const Declarations& known, const Scope& visible, Report to)
      : declarations(&known), scope(&visible), report(std::move(to)) {}

  /// Reports where the expression has not the type.
  void expect(const Expr& expr, const Type& type) const;
  void expectBool(const Expr& expr) const { expect(expr, Type{}); }
  void expectAll(const std::vector<Expr>& exprs, const std::vector<Type>& types,
                 std::string_view what) const;
  /// The type of what is assigned to; reports what cannot be.
  [[nodiscard]] std::optional<Type> target(const Expr& lvalue) const;
  /// Nothing where it has no type, which was reported.
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
  /// The record or union behind a canonical type's name.
  [[nodiscard]] const Type& structure(const Type& type) const;

  const Declarations* declarations;
  const Scope* scope;
  Report report;
};

/// Every part of a type is declared, no range or array is empty.
void checkType(const Type& type, const Declarations& declarations, const Report& report);

} // namespace proskill::fiacre
