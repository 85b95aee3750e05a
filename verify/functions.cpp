#include "verify/expressions.h"
#include "verify/unsupported.h"

#include <algorithm>

/// Calls of functions, inlined: the body is run on expressions instead of values.
namespace proskill::verify {

using fiacre::Expr;
using fiacre::Statement;
using fiacre::StatementKind;
using fiacre::Type;

namespace {

constexpr int kDeepest = 50;
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
    unsupported("`" + expr.name +
                "` is no function of the model; constructors with values are not verified yet");
  if (function->parameters.size() != expr.operands.size())
    unsupported("`" + expr.name + "` is called with the wrong number of arguments");
  if (++depth > kDeepest) unsupported("`" + expr.name + "` calls itself too deeply");
  Scope inner;
  for (std::size_t i = 0; i < expr.operands.size(); ++i) {
    const Type& type = types.resolve(function->parameters[i].type);
    inner[function->parameters[i].name] = {&type, value(expr.operands[i], scope, &type).parts};
  }
  for (const auto& variable : function->variables) {
    const Type& type = types.resolve(variable.type);
    inner[variable.name] =
        variable.init ? Value{&type, value(*variable.init, inner, &type).parts} : lowest(type);
  }
  const Type& result = types.resolve(function->result);
  Value made = run({&function->body}, std::move(inner), result);
  --depth;
  return {&result, made.parts};
}

void Expressions::assignInFunction(const Statement& statement, Scope& scope) {
  std::vector<std::pair<Target, Value>> all;
  for (std::size_t i = 0; i < statement.targets.size(); ++i) {
    Target place = target(statement.targets[i], scope);
    all.emplace_back(place, value(statement.values.at(i), scope, place.type));
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
        Value made = run(std::move(branch), scope, result);
        NodeId condition = matches(statement.values.at(i + 1), tested, scope);
        chosen = chosen ? choose(condition, made, *chosen) : made;
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
    default: unsupported("a statement that functions do not have", statement.origin);
    }
  }
  unsupported("a function may end without `return`");
}

} // namespace proskill::verify
