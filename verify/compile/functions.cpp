#include "fiacre/print/print.h"
#include "verify/compile/expressions.h"
#include "verify/model/value_bounds.h"
#include "verify/unsupported.h"

#include <algorithm>

/// Inlines calls of functions: interprets the body on expressions instead of values.
namespace proskill::verify {

using fiacre::Expr;
using fiacre::Statement;
using fiacre::StatementKind;
using fiacre::Type;

namespace {

constexpr int kDeepestCall = 50;
constexpr int kMostTurns = 64;
constexpr int kMostKnownTurns = 100'000;
constexpr std::int64_t kMostValues = 4096;

void pushReversed(const std::vector<Statement>& children,
                  std::vector<const Statement*>& statements) {
  for (auto child = children.rbegin(); child != children.rend(); ++child)
    statements.push_back(&*child);
}

} // namespace

Types::Bounds Expressions::allValues(const Type& type) const {
  const auto bounds = types.bounds(type);
  if (bounds.high - bounds.low >= kMostValues) unsupported("too many values to go through");
  return bounds;
}

const Statement& Expressions::assignmentOf(const Expr& target, std::int64_t value) {
  made.push_back({.kind = StatementKind::Assign,
                  .targets = {target},
                  .values = {{.kind = fiacre::ExprKind::Number, .number = value}}});
  return made.back();
}

Value Expressions::call(const Expr& expr, const Scope& scope) {
  auto function = std::ranges::find(program.functions, expr.name, &fiacre::Function::name);
  if (function == program.functions.end())
    unsupported("`" + expr.name + "` is not a function of the model");
  if (function->parameters.size() != expr.operands.size())
    unsupported("`" + expr.name + "` is called with the wrong number of arguments");
  if (++depth > kDeepestCall) unsupported("`" + expr.name + "` calls itself too deeply");
  Scope inner;
  std::vector<NodeId> arguments;
  for (std::size_t i = 0; i < expr.operands.size(); ++i) {
    const Type& type = types.resolve(function->parameters[i].type);
    inner[function->parameters[i].name] =
        fitted(value(expr.operands[i], scope, &type), type,
               "`" + function->parameters[i].name + "` of `" + function->name + "`");
    const auto& parts = inner[function->parameters[i].name].parts;
    arguments.insert(arguments.end(), parts.begin(), parts.end());
  }
  for (const auto& variable : function->variables) {
    const Type& type = types.resolve(variable.type);
    inner[variable.name] =
        variable.init ? fitted(value(*variable.init, inner, &type), type, "`" + variable.name + "`")
                      : lowest(type);
  }
  const Type& result = types.resolve(function->result);
  Value made = run({&function->body}, std::move(inner), result);
  --depth;
  made = fitted(std::move(made), result, "the result of `" + function->name + "`");
  for (const auto& argument :
       arguments) // a failing argument fails the call, whether the function reads it or not
    if (verify::mayFail(system, argument))
      for (auto& part : made.parts)
        part = maker.require(maker.equal(argument, argument), part, kNoFault);
  return made;
}

void Expressions::assignInFunction(const Statement& statement, Scope& scope) {
  std::vector<std::pair<Target, Value>> all;
  for (std::size_t i = 0; i < statement.targets.size(); ++i) {
    Target place = target(statement.targets[i], scope);
    all.emplace_back(place, fitted(value(statement.values.at(i), scope, place.type), *place.type,
                                   "`" + fiacre::printLvalue(statement.targets[i]) + "`"));
  }
  for (auto& [place, source] : all) {
    auto root =
        std::ranges::find_if(scope, [&](auto& entry) { return &entry.second == place.root; });
    for (const auto& [condition, offset] : place.offsets) {
      for (std::size_t i = 0; i < source.parts.size(); ++i) {
        NodeId& part = root->second.parts.at(offset + i);
        part = maker.conditional(condition, source.parts[i], part);
      }
    }
  }
}

/// A value whose evaluation fails.
Value Expressions::nothing(Value like, const std::string& why) {
  for (auto& part : like.parts) part = maker.require(maker.number(0), part, maker.fault(why));
  return like;
}

Value Expressions::run(Statements rest, Scope scope, const Type& result) {
  while (!rest.empty()) {
    const Statement& statement = *rest.back();
    rest.pop_back();
    switch (statement.kind) {
    case StatementKind::Null:
    case StatementKind::Comment: break;
    case StatementKind::Sequence: pushReversed(statement.children, rest); break;
    case StatementKind::Assign: assignInFunction(statement, scope); break;
    case StatementKind::Return: return value(statement.values.at(0), scope, &result);
    case StatementKind::If: {
      NodeId condition = scalar(statement.values.at(0), scope);
      auto without = rest;
      if (statement.children.size() > 1) without.push_back(&statement.children[1]);
      rest.push_back(&statement.children.at(0));
      if (auto known = maker.constant(condition)) {
        if (*known == 0) rest = std::move(without);
        break;
      }
      return choose(condition, run(rest, scope, result), run(without, scope, result));
    }
    case StatementKind::Case: {
      Value tested = value(statement.values.at(0), scope);
      std::optional<Value> chosen;
      for (std::size_t i = statement.children.size(); i-- > 0;) {
        auto branch = rest;
        branch.push_back(&statement.children[i]);
        Scope bound = scope;
        for (auto& [variable, part] : bindings(statement.values.at(i + 1), tested, scope))
          bound[variable.name] = {scope.at(variable.name).type, std::move(part.parts)};
        Value made = run(std::move(branch), std::move(bound), result);
        NodeId condition = matches(statement.values.at(i + 1), tested, scope);
        if (!chosen)
          chosen = nothing(made, "no pattern of a `case` matches `" +
                                     fiacre::printExpr(statement.values.at(0)) + "`");
        chosen = choose(condition, made, *chosen);
      }
      if (!chosen) unsupported("a `case` without patterns", statement.origin);
      return *chosen;
    }
    case StatementKind::Foreach: {
      const Expr variable{.kind = fiacre::ExprKind::Name, .name = statement.name};
      const auto all = allValues(typeOf(variable, scope));
      for (auto turn = all.high; turn >= all.low; --turn) {
        rest.push_back(&statement.children.at(0));
        rest.push_back(&assignmentOf(variable, turn));
      }
      break;
    }
    case StatementKind::While: {
      NodeId condition = scalar(statement.values.at(0), scope);
      auto again = rest;
      again.push_back(&statement);
      again.push_back(&statement.children.at(0));
      if (auto known = maker.constant(condition)) {
        if (++turns > kMostKnownTurns) unsupported("a loop in a function does not end");
        if (*known != 0) rest = std::move(again);
        break;
      }
      if (++turns > kMostTurns)
        unsupported("a loop in a function may run more than 64 times", statement.origin);
      Value more = run(std::move(again), scope, result);
      --turns;
      return choose(condition, more, run(rest, scope, result));
    }
    case StatementKind::Any:
    case StatementKind::On:
    case StatementKind::Wait:
    case StatementKind::To:
    case StatementKind::Loop:
    case StatementKind::Select:
    case StatementKind::Send:
    case StatementKind::Receive:
    case StatementKind::Tag:
    case StatementKind::Start:
    case StatementKind::Sync:
      unsupported("a statement that functions do not have", statement.origin);
    }
  }
  unsupported("a function may end without `return`");
}

} // namespace proskill::verify
