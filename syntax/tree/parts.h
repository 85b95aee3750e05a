#pragma once

#include "syntax/tree/ast.h"

#include <concepts>
#include <optional>
#include <tuple>
#include <type_traits>
#include <variant>

/// A walk over all parts of a typed tree, whatever their types.
namespace proskill::syntax {

namespace parts {

template <class T, class Node>
concept Is = std::same_as<std::remove_const_t<T>, Node>;

// The members that are ranges or numbers, or hold some, type by type.
auto of(Is<Name> auto& x) { return std::tie(x.range); }
auto of(Is<Interval> auto& x) { return std::tie(x.range, x.lowerName, x.upperName); }
auto of(Is<Expr> auto& x) { return std::tie(x.range, x.head, x.name, x.member, x.operands); }
auto of(Is<Effect> auto& x) { return std::tie(x.variable, x.value, x.range); }
auto of(Is<Effects> auto& x) { return std::tie(x.items, x.range); }
auto of(Is<FieldUse> auto& x) { return std::tie(x.keyword, x.range); }
auto of(Is<Transition> auto& x) { return std::tie(x.from, x.to, x.range); }
auto of(Is<Input> auto& x) { return std::tie(x.name, x.type, x.range); }
auto of(Is<Precondition> auto& x) { return std::tie(x.tag, x.condition, x.range); }
auto of(Is<Invariant> auto& x) { return std::tie(x.tag, x.guard, x.effects, x.range); }
auto of(Is<Outcome> auto& x) {
  return std::tie(x.tag, x.effects, x.postconditionField, x.postcondition, x.range);
}
auto of(Is<Action> auto& x) { return std::tie(x.command, x.arguments, x.range); }
auto of(Is<Interrupt> auto& x) { return std::tie(x.effects, x.range); }
auto of(Is<Argument> auto& x) { return std::tie(x.name, x.value, x.range); }
auto of(Is<Block> auto& x) { return std::tie(x.statements, x.range); }
auto of(Is<CasePattern> auto& x) { return std::tie(x.status, x.tags, x.range); }
auto of(Is<Arm> auto& x) { return std::tie(x.keyword, x.condition, x.pattern, x.body); }
auto of(Is<UnknownForm> auto& x) { return std::tie(x.head, x.name); }
auto of(Is<Include> auto& x) { return std::tie(x.path); }
auto of(Is<Platform> auto& x) { return std::tie(x.path); }
auto of(Is<Constant> auto& x) { return std::tie(x.name, x.value); }
auto of(Is<Event> auto& x) { return std::tie(x.name, x.fields, x.every, x.guard, x.effects); }
auto of(Is<Resource> auto& x) { return std::tie(x.name, x.fields, x.capacity); }
auto of(Is<Environment> auto& x) { return std::tie(x.name, x.fields, x.body); }
auto of(Is<ReadForm> auto& x) { return std::tie(x.range, x.keyword, x.node); }
auto of(Is<Statement> auto& x) {
  return std::tie(x.range, x.head, x.name, x.format, x.arguments, x.condition, x.duration,
                  x.effects, x.arms, x.branches);
}
auto of(Is<StateVariable> auto& x) {
  return std::tie(x.name, x.fields, x.states, x.init, x.otherInits, x.min, x.max, x.transitions);
}
auto of(Is<Skill> auto& x) {
  return std::tie(x.name, x.fields, x.inputs, x.preconditions, x.start, x.invariants,
                  x.timeInterval, x.action, x.interrupt, x.successes, x.failures, x.resources,
                  x.body);
}
auto of(Is<Property> auto& x) {
  return std::tie(x.name, x.bodyRange, x.head, x.operands, x.fields, x.after, x.before, x.within,
                  x.forDuration, x.lasting, x.fairSkills);
}

template <class Visit> struct Walk {
  Visit& visit;

  template <class T> void operator()(List<T>& items) const {
    for (T& item : items) (*this)(item);
  }
  template <class T> void operator()(const List<T>& items) const {
    for (const T& item : items) (*this)(item);
  }
  template <class T> void operator()(std::optional<T>& item) const {
    if (item) (*this)(*item);
  }
  template <class T> void operator()(const std::optional<T>& item) const {
    if (item) (*this)(*item);
  }
  template <class... T> void operator()(std::variant<T...>& item) const { std::visit(*this, item); }
  template <class... T> void operator()(const std::variant<T...>& item) const {
    std::visit(*this, item);
  }
  template <class T> void operator()(T& part) const {
    if constexpr (std::invocable<Visit&, T&>) visit(part);
    if constexpr (requires { of(part); })
      std::apply([this](auto&... each) { ((*this)(each), ...); }, of(part));
  }
};

} // namespace parts

/// Calls `visit(part)` for each part of a kind that it takes, outer before inner: ranges, names,
/// expressions, intervals, statements and so on.
template <class Node, class Visit> void forEachPart(Node& node, Visit visit) {
  parts::Walk<Visit>{visit}(node);
}

} // namespace proskill::syntax
