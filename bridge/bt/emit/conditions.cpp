#include "bridge/bt/emit/conditions.h"

#include "bridge/bt/emit/calls.h"
#include "bridge/bt/emit/elements.h"
#include "bridge/bt/tree/traits.h"

#include <fmt/ranges.h>

#include <utility>

namespace proskill::bridge::bt {

using Is = syntax::ExprKind;

Conditions::Conditions(Draft& draft) : variables(draft.program), draft(draft) {
  for (const auto& skill : draft.program.skills.all) skills.insert(Calls::nameOf(skill));
}

Element Conditions::of(const syntax::Expr& test, analysis::FileId at) {
  begin();
  return another(test, at);
}

Element Conditions::ofGuard(const syntax::Expr& test, analysis::FileId at) {
  isGuard = true;
  auto made = of(test, at);
  isGuard = false;
  return made;
}

void Conditions::checkGuards() {
  for (const auto& [variable, at] : guarded)
    if (tests[variable] > 1)
      draft.fail(at, fmt::format("a guard with `{}`, which is tested elsewhere, too", variable));
}

Element Conditions::another(const syntax::Expr& test, analysis::FileId at) {
  file = at;
  switch (test.kind) {
  case Is::True: return constant(true);
  case Is::False: return constant(false);
  case Is::Test: return this->test(test.name, test.operands.front());
  case Is::Equal: return compared(test, "==");
  case Is::NotEqual: return compared(test, "!=");
  case Is::Less: return compared(test, "<");
  case Is::LessEqual: return compared(test, "<=");
  case Is::Greater: return compared(test, ">");
  case Is::GreaterEqual: return compared(test, ">=");
  case Is::And: return joined(test, true);
  case Is::Or: return joined(test, false);
  case Is::Not: return withResults(another(test.operands.front(), at), false, true);
  case Is::Implies: {
    auto given = withResults(another(test.operands.front(), at), false, true);
    return inOrder(false, std::move(given), another(test.operands.back(), at));
  }
  case Is::Parameter: return fail(test, "a test of an input");
  case Is::Equivalent:
  case Is::Missing:
  case Is::Number:
  case Is::Symbol:
  case Is::String:
  case Is::Access:
  case Is::Add:
  case Is::Subtract:
  case Is::Running:
  case Is::Called:
  case Is::Ended:
  case Is::Occurs:
  case Is::At:
  case Is::Value:
  case Is::Globally:
  case Is::Finally:
  case Is::Next:
  case Is::Until:
  case Is::WeakUntil:
  case Is::Release:
  case Is::StrongRelease: return fail(test, "a condition of this kind");
  }
  std::unreachable();
}

Element Conditions::joined(const syntax::Expr& test, bool isAnd) {
  auto result = constant(isAnd);
  for (const auto& operand : test.operands)
    result = inOrder(isAnd, std::move(result), another(operand, file));
  return result;
}

bool Conditions::isVariable(const syntax::Expr& expr) const {
  return expr.kind == Is::Symbol && draft.program.stateVariables.find(expr.name.text) != nullptr;
}

Element Conditions::compared(const syntax::Expr& test, const char* sign) {
  const auto& left = test.operands.front();
  const auto& right = test.operands.back();
  if (left.kind == Is::Access || right.kind == Is::Access)
    return fail(test, "the status of a call that is not tested right after the call, by itself");
  if (left.kind == Is::Parameter || right.kind == Is::Parameter)
    return fail(test, "a test of an input");
  const bool isEquality = test.kind == Is::Equal || test.kind == Is::NotEqual;
  const auto& variable = isVariable(left) ? left : right;
  const auto& other = isVariable(left) ? right : left;
  const bool isState =
      isEquality && isVariable(variable) && other.kind == Is::Symbol && !isVariable(other);
  if (isState)
    return withResults(this->test(variable.name, other), test.kind == Is::Equal,
                       test.kind != Is::Equal);
  const auto code = fmt::format("{} {} {}", value(left), sign, value(right));
  return element("ScriptCondition", {{"code", code}});
}

Element Conditions::test(const syntax::Name& variable, const syntax::Expr& state) {
  const auto& known = *draft.program.stateVariables.find(variable.text);
  const auto changed = variables.changed(variable.text);
  if (changed == Changed::Otherwise && known->isNatural())
    return fail(state,
                fmt::format("a test of the number `{}`, which skills change", variable.text));
  if (state.kind != Is::Symbol && changed != Changed::ByBodies)
    return fail(state, "a test for a state that is not spelt out");
  if (isGuard && changed == Changed::Otherwise)
    return fail(state, fmt::format("a guard with `{}`, which skills change", variable.text));
  if (isGuard) guarded.emplace(variable.text, analysis::Location{file, variable.range});
  ++tests[variable.text];
  switch (changed) {
  case Changed::Freely:
  case Changed::Never:
    if (!seen.insert(variable.text).second)
      return fail(state, fmt::format("two tests of `{}` in one instant", variable.text));
    return world(known.node(), state.name.text, changed == Changed::Freely);
  case Changed::ByBodies:
    return element("ScriptCondition",
                   {{"code", fmt::format("{} == {}", entry(variable), value(state))}});
  case Changed::Otherwise: return reported(known.node(), state);
  }
  std::unreachable();
}

/// A tree reads one condition after the other, and skills may change two variables at once.
Element Conditions::reported(const syntax::StateVariable& variable, const syntax::Expr& state) {
  if (std::exchange(hasReported, true))
    return fail(state, "two tests of variables that skills change, in one instant");
  draft.note({file, state.range},
             fmt::format("how `{}` changes: that is up to the leaf", variable.name.text));
  return world(variable, state.name.text, true);
}

/// Of a variable with two states, one condition is enough.
Element Conditions::world(const syntax::StateVariable& variable, std::string_view state,
                          bool changes) {
  const auto& states = variable.states;
  const bool isTwo = states.size() == 2;
  const bool isAnswer = isTwo && ((states[0].text == "Yes" && states[1].text == "No") ||
                                  (states[0].text == "No" && states[1].text == "Yes"));
  const auto positive = isAnswer ? std::string_view("Yes") : isTwo ? states[0].text : state;
  const auto [found, isNew] = ids.try_emplace({variable.name.text, positive});
  auto& id = found->second;
  if (isNew) {
    const auto name = std::string(variable.name.text);
    id = freeId(isAnswer ? name : fmt::format("{}_is_{}", name, positive), name);
    conditions.emplace(id, changes);
  }
  auto leaf = element("Condition", {{"ID", id}});
  return state == positive ? leaf : withResults(std::move(leaf), false, true);
}

std::string Conditions::freeId(std::string id, std::string_view variable) const {
  const auto isTaken = [&] {
    const bool isVariable = id != variable && draft.program.stateVariables.find(id) != nullptr;
    return isVariable || conditions.contains(id) || skills.contains(id);
  };
  if (builtIn(id) != nullptr) id += "_leaf"; // as what `ScriptCondition` is imported as
  while (isTaken()) id += '_';
  return id;
}

std::string Conditions::entry(const syntax::Name& variable) {
  if (variables.changed(variable.text) != Changed::ByBodies)
    draft.fail({file, variable.range},
               fmt::format("a script with `{}`, which not only bodies change", variable.text));
  if (isGuard)
    draft.fail({file, variable.range},
               fmt::format("a guard with `{}`, which skills change", variable.text));
  entries.insert(variable.text);
  return fmt::format("@{}", variable.text);
}

std::string Conditions::value(const syntax::Expr& expr) {
  if (expr.kind == Is::Number) return syntax::toString(expr.number);
  if (expr.kind == Is::Symbol)
    return isVariable(expr) ? entry(expr.name) : fmt::format("'{}'", expr.name.text);
  if (expr.kind == Is::Add || expr.kind == Is::Subtract) {
    std::vector<std::string> parts;
    for (const auto& operand : expr.operands) parts.push_back(value(operand));
    return fmt::format("({})", fmt::join(parts, expr.kind == Is::Add ? " + " : " - "));
  }
  fail(expr, "a value of this kind");
  return {};
}

/// A number stays within its bounds.
std::string Conditions::assigned(const syntax::StateVariable& variable, const syntax::Expr& expr) {
  auto result = value(expr);
  const bool isWithin = expr.kind == Is::Number && variable.min && variable.max &&
                        variable.min->number <= expr.number && expr.number <= variable.max->number;
  if (isWithin) return result;
  if (variable.min) {
    const auto least = value(*variable.min);
    result = fmt::format("({0} < {1} ? {1} : {0})", result, least);
  }
  if (variable.max) {
    const auto most = value(*variable.max);
    result = fmt::format("({0} > {1} ? {1} : {0})", result, most);
  }
  return result;
}

std::string Conditions::script(const syntax::Effects& effects, analysis::FileId at) {
  file = at;
  std::vector<std::string> parts;
  for (const auto& effect : effects.items) {
    const auto& variable = *draft.program.stateVariables.find(effect.variable.text);
    parts.push_back(
        fmt::format("{} := {}", entry(effect.variable), assigned(variable.node(), effect.value)));
  }
  if (parts.size() > 1) draft.fail({at, effects.range}, "several effects at once");
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::string Conditions::initially() const {
  std::vector<std::string> parts;
  for (const auto& name : entries) {
    const auto& variable = *draft.program.stateVariables.find(name);
    const auto& init = variable->init;
    const auto first = init.kind == Is::Number ? syntax::toString(init.number)
                       : variable->min         ? syntax::toString(variable->min->number)
                       : variable->isNatural() ? std::string("0")
                       : init.kind == Is::Symbol
                           ? fmt::format("'{}'", init.name.text)
                           : fmt::format("'{}'", variable->states.front().text);
    parts.push_back(fmt::format("@{} := {}", name, first));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

Element Conditions::fail(const syntax::Expr& expr, std::string_view what) {
  draft.fail({file, expr.range}, what);
  return constant(true);
}

} // namespace proskill::bridge::bt
