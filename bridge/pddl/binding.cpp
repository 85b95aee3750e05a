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

/// From the least to the greatest, or nothing if there are too many.
std::vector<Expr> numbers(const syntax::StateVariable& variable) {
  if (!variable.min || !variable.max) return {};
  const auto least = variable.min->number.numerator;
  const auto most = variable.max->number.numerator;
  std::vector<Expr> all;
  if (most - least >= static_cast<std::int64_t>(kMost)) return all;
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
      return std::unexpected(
          fmt::format("the input `{}` of `{}` does not have a list of at most {} values",
                      bare(input.name.text), skill.name.text, kMost));
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
