#include "codegen/term/inputs.h"

#include "codegen/term/conditions.h"
#include "codegen/term/linear.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::codegen {
namespace {

using fiacre::Statement;

std::string_view withoutDollar(std::string_view input) { return input.substr(1); }

fiacre::Expr variableOf(Context& context, const SkillPlan& skill, const syntax::Input& input) {
  return name(context.names.input(skill.name(), input.name.text));
}

std::vector<fiacre::Expr> valuesOf(Context& context, const syntax::Input& input) {
  const auto* type = context.typeOf(input);
  if (!type) return {boolean(false), boolean(true)};
  std::vector<fiacre::Expr> all;
  for (const auto& state : type->states)
    all.push_back(name(context.names.value(type->name.text, state.text)));
  if (!type->isNatural()) return all;
  const auto [low, high] = domainOf(*type);
  for (auto each = low; each <= high; ++each) all.push_back(number(each));
  return all;
}

/// The argument as a value of the input's type: a truth value, a number, one of the type's values,
/// or the caller's own input.
fiacre::Expr argument(Context& context, const syntax::Expr& expr, const syntax::Input& input) {
  const auto* type = context.typeOf(input);
  if (!type) return condition(context, expr);
  if (type->isNatural()) return Linear(context, expr).expr();
  return enumerationValue(context, *type, expr);
}

fiacre::Type typeOf(Context& context, const syntax::Input& input) {
  const auto* type = context.typeOf(input);
  return type ? namedType(context.names.type(type->name.text)) : boolType();
}

} // namespace

Statement setInputs(Context& context, const SkillPlan& callee, const syntax::Statement& call) {
  std::vector<Statement> all;
  for (const auto* input : callee.inputs) {
    const auto bare = withoutDollar(input->name.text);
    const auto given = std::ranges::find_if(
        call.arguments, [&](const auto& each) { return each.name.text == bare; });
    if (given != call.arguments.end())
      all.push_back(
          assign(variableOf(context, callee, *input), argument(context, given->value, *input)));
  }
  return sequence(std::move(all));
}

Statement chooseInputs(Context& context, const SkillPlan& callee) {
  std::vector<Statement> all;
  for (const auto* input : callee.inputs) {
    std::vector<Statement> choices;
    for (auto& value : valuesOf(context, *input))
      choices.push_back(assign(variableOf(context, callee, *input), std::move(value)));
    all.push_back(select(std::move(choices)));
  }
  return sequence(std::move(all));
}

std::string shownInput(std::string_view skill, std::string_view input) {
  return fmt::format("{}.{}", skill, withoutDollar(input));
}

std::vector<fiacre::Variable> inputVariables(Context& context) {
  std::vector<fiacre::Variable> all;
  for (const auto& skill : context.plan.skills)
    for (const auto* input : skill.inputs)
      all.push_back({context.names.input(skill.name(), input->name.text), typeOf(context, *input),
                     valuesOf(context, *input).front(),
                     fmt::format("`{}` of the last call of {}", input->name.text, skill.name())});
  return all;
}

} // namespace proskill::codegen
