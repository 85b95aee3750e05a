#include "bridge/pddl/binding.h"

#include "syntax/tree/parts.h"

#include <fmt/format.h>

#include <set>

namespace proskill::bridge::pddl {
namespace {

using syntax::Expr;
using Kind = syntax::ExprKind;

constexpr std::size_t kMost = 1'000;

std::set<std::string_view> inputsRead(const syntax::Skill& skill) {
  std::set<std::string_view> all;
  const auto note = [&](const Expr& expr) {
    if (expr.kind == Kind::Parameter) all.insert(expr.name.text);
  };
  for (const auto& each : skill.preconditions) syntax::forEachPart(each.condition, note);
  for (const auto& each : skill.invariants) syntax::forEachPart(each.guard, note);
  syntax::forEachPart(skill.start, note);
  syntax::forEachPart(skill.successes, note);
  syntax::forEachPart(skill.failures, note);
  return all;
}

Expr numbered(std::int64_t value) {
  Expr expr;
  expr.kind = Kind::Number;
  expr.number = syntax::Rational{value};
  return expr;
}

std::vector<Expr> truths() {
  std::vector<Expr> both(2);
  both[0].kind = Kind::True;
  both[1].kind = Kind::False;
  return both;
}

/// How many values a number has.
std::int64_t countOf(const syntax::StateVariable& variable) {
  return variable.max->number.numerator - variable.min->number.numerator + 1;
}

/// From the least to the greatest, or nothing if there are too many.
std::vector<Expr> numbers(const syntax::StateVariable& variable) {
  std::vector<Expr> all;
  if (countOf(variable) > static_cast<std::int64_t>(kMost)) return all;
  const auto least = variable.min->number.numerator;
  const auto most = variable.max->number.numerator;
  for (auto value = least; value <= most; ++value) all.push_back(numbered(value));
  return all;
}

/// The values of a type, or nothing if there is no list of them.
std::vector<Expr> valuesOf(const analysis::Program& program, std::string_view type) {
  if (type == "bool") return truths();
  const auto* variable = program.stateVariables.find(type);
  if (!variable) return {};
  if (variable->node().isNatural()) return numbers(variable->node());
  std::vector<Expr> all;
  for (const auto& state : variable->node().states) {
    auto& value = all.emplace_back();
    value.kind = Kind::Symbol;
    value.name = state;
  }
  return all;
}

/// Why there is no list of the values of an input.
std::string noList(const analysis::Program& program, const syntax::Skill& skill,
                   std::string_view input, std::string_view type) {
  const auto* variable = program.stateVariables.find(type);
  if (!variable)
    return fmt::format("the conditions and effects of `{}` read its input `{}`, and the values of "
                       "`{}` cannot be listed; declare a state variable with them, and use it as "
                       "the type",
                       skill.name.text, input, type);
  return fmt::format("`{}` needs an action for each value of its input `{}`, and `{}` has {} of "
                     "them, more than {}; read the input in the action only, or use fewer values",
                     skill.name.text, input, type, countOf(variable->node()), kMost);
}

std::string tooMany(const syntax::Skill& skill, const std::string& counts) {
  return fmt::format("`{}` needs an action for each combination of the values of its inputs, more "
                     "than {} ({}); read fewer inputs in its conditions and effects, or split it",
                     skill.name.text, kMost, counts);
}

} // namespace

std::expected<std::vector<Binding>, std::string> bindingsOf(const analysis::Program& program,
                                                            const syntax::Skill& skill) {
  const auto read = inputsRead(skill);
  std::vector<Binding> all(1);
  std::string counts;
  for (const auto& input : skill.inputs) {
    if (!read.contains(input.name.text)) continue;
    const auto values = valuesOf(program, input.type.text);
    if (values.empty())
      return std::unexpected(noList(program, skill, bare(input.name.text), input.type.text));
    counts += fmt::format("{}{} of `{}`", counts.empty() ? "" : ", ", values.size(),
                          bare(input.name.text));
    if (all.size() * values.size() > kMost) return std::unexpected(tooMany(skill, counts));
    std::vector<Binding> longer;
    for (const auto& binding : all)
      for (const auto& value : values) {
        longer.push_back(binding);
        longer.back().emplace(input.name.text, value);
      }
    all = std::move(longer);
  }
  return all;
}

} // namespace proskill::bridge::pddl
