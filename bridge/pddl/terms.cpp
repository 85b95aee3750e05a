#include "bridge/pddl/terms.h"

#include "bridge/text/locate.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace proskill::bridge::pddl {
namespace {

using Kind = syntax::ExprKind;

std::string inLowerCase(std::string_view text) {
  std::string all(text);
  for (char& c : all) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '_') c = '-';
  }
  return all;
}

bool hasValue(const syntax::StateVariable& variable, std::string_view value) {
  return std::ranges::find(variable.states, value, &syntax::Name::text) != variable.states.end();
}

} // namespace

Terms::Terms(const analysis::Program& program, Errors& errors) : program(program), errors(errors) {
  for (const auto& variable : program.stateVariables.all) {
    if (variable->isNatural())
      static_cast<void>(function(variable.name()));
    else
      for (const auto& state : variable->states)
        static_cast<void>(has(variable.name(), state.text));
  }
}

std::string Terms::name(const std::string& key, std::string_view wish) {
  const auto [known, isNew] = names.try_emplace(key);
  if (!isNew) return known->second;
  auto word = inLowerCase(wish);
  if (word.empty() || word.front() < 'a' || word.front() > 'z') word = "n-" + word;
  const auto first = word;
  for (int number = 2; !taken.insert(word).second; ++number)
    word = fmt::format("{}-{}", first, number);
  return known->second = word;
}

std::string Terms::has(std::string_view variable, std::string_view value) {
  const auto key = fmt::format("value {} {}", variable, value);
  return "(" + name(key, fmt::format("{}-is-{}", variable, value)) + ")";
}

std::string Terms::function(std::string_view natural) {
  return "(" + name(fmt::format("number {}", natural), natural) + ")";
}

const syntax::StateVariable* Terms::enumeration(std::string_view called) const {
  const auto* variable = program.stateVariables.find(called);
  return variable && !variable->node().isNatural() ? &variable->node() : nullptr;
}

/// The value of an input; any other expression as it is.
const syntax::Expr& Terms::bound(const syntax::Expr& expr) const {
  const auto found = expr.kind == Kind::Parameter ? binding.find(expr.name.text) : binding.end();
  return found == binding.end() ? expr : found->second;
}

std::string Terms::fail(const syntax::Expr& expr, const char* what) {
  const Error error{placeOf(program, {file, expr.range}),
                    fmt::format("PDDL cannot say this: {}", what)};
  // An expression is written for each value of the inputs.
  if (std::ranges::find(errors, error) == errors.end()) errors.push_back(error);
  return "(and)";
}

std::string Terms::joined(const syntax::Expr& expr, const char* word) {
  std::string text = fmt::format("({}", word);
  for (const auto& operand : expr.operands) text += " " + condition(operand);
  return text + ")";
}

std::string Terms::number(const syntax::Expr& of) {
  const auto& expr = bound(of);
  if (expr.kind == Kind::Number) return syntax::toString(expr.number);
  if (expr.kind == Kind::Add || expr.kind == Kind::Subtract) {
    auto text = number(expr.operands.front());
    for (std::size_t i = 1; i < expr.operands.size(); ++i)
      text = fmt::format("({} {} {})", expr.kind == Kind::Add ? "+" : "-", text,
                         number(expr.operands[i]));
    return text;
  }
  const bool isVariable =
      expr.kind == Kind::Symbol && program.stateVariables.find(expr.name.text) != nullptr;
  if (isVariable && !enumeration(expr.name.text)) {
    usesNumbers = true;
    return function(expr.name.text);
  }
  fail(of, "a value that is not a number");
  return "0";
}

std::string Terms::comparison(const syntax::Expr& expr, const char* word) {
  return fmt::format("({} {} {})", word, number(expr.operands.front()),
                     number(expr.operands.back()));
}

/// Whether an operand of an equality is the same whatever the state is.
bool Terms::isValue(const syntax::Expr& operand) const {
  const auto kind = bound(operand).kind;
  if (kind == Kind::Symbol)
    return operand.kind == Kind::Parameter || !program.stateVariables.find(operand.name.text);
  return kind == Kind::True || kind == Kind::False || kind == Kind::Number;
}

/// Of two operands that do not depend on the state.
std::optional<bool> Terms::areSame(const syntax::Expr& expr) const {
  if (!isValue(expr.operands.front()) || !isValue(expr.operands.back())) return std::nullopt;
  const auto& left = bound(expr.operands.front());
  const auto& right = bound(expr.operands.back());
  if (left.kind != right.kind) return false;
  if (left.kind == Kind::Number) return left.number == right.number;
  return left.kind != Kind::Symbol || left.name.text == right.name.text;
}

std::string Terms::equality(const syntax::Expr& expr) {
  if (const auto same = areSame(expr)) return *same ? "(and)" : "(or)";
  const auto& left = bound(expr.operands.front());
  const auto& right = bound(expr.operands.back());
  if (left.kind == Kind::Access || right.kind == Kind::Access)
    return fail(expr, "a condition about a skill");
  if (left.kind == Kind::Parameter || right.kind == Kind::Parameter)
    return fail(expr, "a test of an input");
  const auto* a = left.kind == Kind::Symbol ? enumeration(left.name.text) : nullptr;
  const auto* b = right.kind == Kind::Symbol ? enumeration(right.name.text) : nullptr;
  if (a && right.kind == Kind::Symbol && hasValue(*a, right.name.text))
    return has(left.name.text, right.name.text);
  if (b && left.kind == Kind::Symbol && hasValue(*b, left.name.text))
    return has(right.name.text, left.name.text);
  if (!a || !b) return comparison(expr, "=");
  std::string text = "(or";
  for (const auto& state : a->states)
    if (hasValue(*b, state.text))
      text += fmt::format(" (and {} {})", has(left.name.text, state.text),
                          has(right.name.text, state.text));
  return text + ")";
}

std::string Terms::condition(const syntax::Expr& of) {
  const auto& expr = bound(of);
  switch (expr.kind) {
  case Kind::True: return "(and)";
  case Kind::False: return "(or)";
  case Kind::Test: {
    const auto& value = bound(expr.operands.front());
    if (enumeration(expr.name.text) && value.kind == Kind::Symbol)
      return has(expr.name.text, value.name.text);
    usesNumbers = true;
    return fmt::format("(= {} {})", function(expr.name.text), number(value));
  }
  case Kind::Equal: return equality(expr);
  case Kind::NotEqual: return "(not " + equality(expr) + ")";
  case Kind::Less: return comparison(expr, "<");
  case Kind::LessEqual: return comparison(expr, "<=");
  case Kind::Greater: return comparison(expr, ">");
  case Kind::GreaterEqual: return comparison(expr, ">=");
  case Kind::And: return joined(expr, "and");
  case Kind::Or: return joined(expr, "or");
  case Kind::Not: return joined(expr, "not");
  case Kind::Implies:
    return fmt::format("(or (not {}) {})", condition(expr.operands.front()),
                       condition(expr.operands.back()));
  case Kind::Equivalent: {
    const auto left = condition(expr.operands.front());
    const auto right = condition(expr.operands.back());
    return fmt::format("(or (and {0} {1}) (and (not {0}) (not {1})))", left, right);
  }
  case Kind::Parameter: return fail(expr, "a test of an input");
  case Kind::Missing:
  case Kind::Number:
  case Kind::Symbol:
  case Kind::String:
  case Kind::Access:
  case Kind::Add:
  case Kind::Subtract:
  case Kind::Running:
  case Kind::Called:
  case Kind::Ended:
  case Kind::Occurs:
  case Kind::At:
  case Kind::Value:
  case Kind::Globally:
  case Kind::Finally:
  case Kind::Next:
  case Kind::Until:
  case Kind::WeakUntil:
  case Kind::Release:
  case Kind::StrongRelease: return fail(expr, "a condition that is not about state variables");
  }
  std::unreachable();
}

std::vector<std::string> Terms::moves(std::string_view variable, std::string_view value) {
  std::vector<std::string> all;
  for (const auto& state : enumeration(variable)->states)
    if (state.text != value) all.push_back("(not " + has(variable, state.text) + ")");
  all.push_back(has(variable, value));
  return all;
}

std::vector<std::string> Terms::effects(const syntax::Effects& list) {
  std::vector<std::string> all;
  for (const auto& effect : list.items) {
    const auto& value = bound(effect.value);
    const auto* variable = enumeration(effect.variable.text);
    if (!variable) {
      usesNumbers = true;
      all.push_back(fmt::format("(assign {} {})", function(effect.variable.text), number(value)));
    } else if (value.kind == Kind::Symbol && hasValue(*variable, value.name.text)) {
      std::ranges::move(moves(effect.variable.text, value.name.text), std::back_inserter(all));
    } else {
      fail(effect.value, "an effect that copies a variable");
    }
  }
  return all;
}

/// The variable has the value already, or one from which a transition leads to it.
void Terms::allowMove(const syntax::StateVariable& variable, const syntax::Expr& value,
                      std::vector<std::string>& to) {
  if (variable.transitionsKind != syntax::Transitions::Listed || value.kind != Kind::Symbol) return;
  std::string before = has(variable.name.text, value.name.text);
  for (const auto& transition : variable.transitions)
    if (transition.to.text == value.name.text && transition.from.text != value.name.text)
      before += " " + has(variable.name.text, transition.from.text);
  to.push_back("(or " + before + ")");
}

void Terms::allowNumber(const syntax::StateVariable& variable, const syntax::Expr& value,
                        std::vector<std::string>& to) {
  if (value.kind == Kind::Number) return; // the analysis has compared it
  const auto text = number(value);
  if (variable.min) to.push_back(fmt::format("(>= {} {})", text, number(*variable.min)));
  if (variable.max) to.push_back(fmt::format("(<= {} {})", text, number(*variable.max)));
}

std::vector<std::string> Terms::allowing(const syntax::Effect& effect) {
  std::vector<std::string> all;
  const auto* variable = program.stateVariables.find(effect.variable.text);
  if (!variable) return all;
  const auto& value = bound(effect.value);
  if (variable->node().isNatural())
    allowNumber(variable->node(), value, all);
  else
    allowMove(variable->node(), value, all);
  return all;
}

std::optional<std::vector<std::string>> Terms::making(const syntax::Expr& expr) {
  if (expr.kind == Kind::And) {
    std::vector<std::string> all;
    for (const auto& operand : expr.operands) {
      auto some = making(operand);
      if (!some) return std::nullopt;
      std::ranges::move(*some, std::back_inserter(all));
    }
    return all;
  }
  const bool isTest = expr.kind == Kind::Test;
  if (!isTest && expr.kind != Kind::Equal) return std::nullopt;
  const auto& variable = isTest ? expr.name : expr.operands.front().name;
  const auto& value = bound(expr.operands.back());
  const auto* known = enumeration(variable.text);
  if (!known || value.kind != Kind::Symbol || !hasValue(*known, value.name.text))
    return std::nullopt;
  return moves(variable.text, value.name.text);
}

} // namespace proskill::bridge::pddl
