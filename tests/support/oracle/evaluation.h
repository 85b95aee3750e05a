#pragma once

#include "tests/support/oracle/interpreter.h"

#include <string_view>

namespace proskill::oracle {

/// Number of slots of a value of the type.
[[nodiscard]] std::size_t slotCount(const Interpreter& model, const fiacre::Type& type);

/// Evaluates expressions of the tree in a store. Types are looked up each time: slow but simple.
class Evaluation {
public:
  Evaluation(const Interpreter& of, Store& in, const Scope& names)
      : model(of), store(in), scope(names) {}

  /// \param expected the type that the context requires, for constructors shared by unions
  [[nodiscard]] std::int64_t number(const fiacre::Expr& expr,
                                    const fiacre::Type* expected = nullptr);
  [[nodiscard]] Store value(const fiacre::Expr& expr, const fiacre::Type* expected = nullptr);
  [[nodiscard]] bool truth(const fiacre::Expr& expr) { return number(expr) != 0; }
  /// The slot of an lvalue; nullopt for other expressions.
  [[nodiscard]] std::optional<Place> place(const fiacre::Expr& expr);
  /// nullopt for a bare constructor.
  [[nodiscard]] const fiacre::Type* typeOf(const fiacre::Expr& expr);
  void assign(Place target, const Store& value);
  /// Whether a value matches the pattern of a `case`; binds the variable of
  /// `constructor(variable)`.
  [[nodiscard]] bool matches(const fiacre::Expr& pattern, const Store& value,
                             const fiacre::Type& type);

private:
  [[nodiscard]] const fiacre::Type& resolve(const fiacre::Type& type) const;
  [[nodiscard]] std::int64_t name(const std::string& name, const fiacre::Type* expected);
  [[nodiscard]] std::optional<std::int64_t> constructor(const fiacre::Type& type,
                                                        std::string_view name) const;
  [[nodiscard]] const fiacre::Type& unionOf(std::string_view name) const;
  [[nodiscard]] std::int64_t unary(const fiacre::Expr& expr);
  [[nodiscard]] std::int64_t binary(const fiacre::Expr& expr);
  [[nodiscard]] bool equal(const fiacre::Expr& left, const fiacre::Expr& right);
  [[nodiscard]] Store construct(const fiacre::Expr& expr, const fiacre::Type* expected);
  [[nodiscard]] Store queue(const fiacre::Expr& expr, const fiacre::Type* expected);
  [[nodiscard]] Store call(const fiacre::Function& function, const fiacre::Expr& expr);
  /// Executes a statement of a function. \return true if it has returned into `result`
  bool execute(const fiacre::Statement& statement, const fiacre::Type& type, Store& result);
  bool repeat(const fiacre::Statement& statement, const fiacre::Type& type, Store& result);

  const Interpreter& model;
  Store& store;
  const Scope& scope;
};

/// The minimum and the maximum of a scalar type with few values, for `any`, `foreach` and `?`.
struct Bounds {
  std::int64_t low = 0;
  std::int64_t high = 0;
};
[[nodiscard]] Bounds boundsOf(const Interpreter& model, const fiacre::Type& type);
/// Every value of a scalar type, or of a union with values of such types.
[[nodiscard]] std::vector<Store> valuesOf(const Interpreter& model, const fiacre::Type& type);
[[nodiscard]] const fiacre::Type& resolveType(const Interpreter& model, const fiacre::Type& type);
/// The value of a scalar as text.
[[nodiscard]] std::string textOf(const Interpreter& model, Place scalar, const Store& store);
/// The value of an uninitialised variable: false, the lowest number, the first constructor.
[[nodiscard]] Store defaultValue(const Interpreter& model, const fiacre::Type& type);

} // namespace proskill::oracle
