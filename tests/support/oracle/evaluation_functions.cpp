#include "tests/support/oracle/evaluation.h"

#include <algorithm>

namespace proskill::oracle {

using fiacre::Expr;
using fiacre::ExprKind;
using fiacre::Op;
using fiacre::Statement;
using fiacre::StatementKind;
using fiacre::Type;
using fiacre::TypeKind;

Store Evaluation::call(const fiacre::Function& function, const Expr& expr) {
  const std::size_t before = store.size();
  Scope names;
  auto push = [&](const Store& value, const Type& type) {
    Place at{store.size(), &type};
    store.insert(store.end(), value.begin(), value.end());
    return at;
  };
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const auto& parameter = function.parameters[i];
    // functions do not write, so a variable may be passed itself
    auto shared = place(expr.operands[i]);
    names[parameter.name] =
        shared ? *shared : push(value(expr.operands[i], &parameter.type), parameter.type);
  }
  for (const auto& variable : function.variables)
    names[variable.name] = push(defaultValue(model, variable.type), variable.type);
  Evaluation inner(model, store, names);
  for (const auto& variable : function.variables)
    if (variable.init)
      inner.assign(names[variable.name], inner.value(*variable.init, &variable.type));
  Store result;
  if (!inner.execute(function.body, function.result, result))
    throw ModelError("a function without a result: " + function.name);
  store.resize(before);
  return result;
}

bool Evaluation::execute(const Statement& statement, const Type& type, Store& result) {
  switch (statement.kind) {
  case StatementKind::Null:
  case StatementKind::Comment: return false;
  case StatementKind::Sequence:
    return std::ranges::any_of(
        statement.children, [&](const Statement& child) { return execute(child, type, result); });
  case StatementKind::Return: result = value(statement.values[0], &type); return true;
  case StatementKind::If:
    if (truth(statement.values[0])) return execute(statement.children[0], type, result);
    return statement.children.size() > 1 && execute(statement.children[1], type, result);
  case StatementKind::Case: {
    const Type* of = typeOf(statement.values[0]);
    Store tested = value(statement.values[0]);
    for (std::size_t i = 0; i < statement.children.size(); ++i)
      if (matches(statement.values[i + 1], tested, *of))
        return execute(statement.children[i], type, result);
    throw ModelError("match error in function");
  }
  case StatementKind::Assign: {
    std::vector<Store> values;
    for (std::size_t i = 0; i < statement.targets.size(); ++i)
      values.push_back(value(statement.values[i], place(statement.targets[i])->type));
    for (std::size_t i = 0; i < statement.targets.size(); ++i)
      assign(*place(statement.targets[i]), values[i]);
    return false;
  }
  case StatementKind::While:
  case StatementKind::Foreach: return repeat(statement, type, result);
  default: throw ModelError("a statement that functions do not have");
  }
}

bool Evaluation::repeat(const Statement& statement, const Type& type, Store& result) {
  if (statement.kind == StatementKind::While) {
    while (truth(statement.values[0]))
      if (execute(statement.children[0], type, result)) return true;
    return false;
  }
  Place counter = scope.at(statement.name);
  auto [low, high] = boundsOf(model, *counter.type);
  for (auto i = low; i <= high; ++i) {
    store[counter.offset] = i;
    if (execute(statement.children[0], type, result)) return true;
  }
  return false;
}

} // namespace proskill::oracle
