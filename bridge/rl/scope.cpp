#include "bridge/rl/scope.h"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace proskill::bridge::rl {

void Scope::add(const Resource& resource, std::string name) {
  const auto [known, isNew] = resources.try_emplace(resource.name.text);
  if (!isNew)
    return errors.push_back(
        {resource.name.place, fmt::format("a second resource is called `{}`", resource.name.text)});
  known->second.name = std::move(name);
  NamePool states;
  for (const auto& state : resource.states)
    if (!known->second.states.contains(state.text))
      known->second.states[state.text] = states.take(state.text);
    else
      errors.push_back({state.place, fmt::format("`{}` is listed twice", state.text)});
}

Scope::Known* Scope::find(const Word& resource) {
  const auto known = resources.find(resource.text);
  if (known != resources.end()) return &known->second;
  errors.push_back({resource.place, fmt::format("unknown resource `{}`", resource.text)});
  return nullptr;
}

std::string Scope::stateOf(const Word& resource, const Word& state) {
  const auto* known = find(resource);
  if (known == nullptr) return "unknown";
  const auto found = known->states.find(state.text);
  if (found != known->states.end()) return found->second;
  errors.push_back(
      {state.place, fmt::format("`{}` is not a state of `{}`", state.text, resource.text)});
  return "unknown";
}

Form Scope::comparison(const Expr& expr) {
  const auto state = stateOf(expr.resource, expr.state);
  const auto known = resources.find(expr.resource.text);
  const auto name = known == resources.end() ? std::string("unknown") : known->second.name;
  return expr.kind == ExprKind::Is ? list(name, state) : list("/=", name, state);
}

Form Scope::condition(const Expr& expr) {
  const auto join = [&](const char* word) {
    Form joined = list(word);
    for (const auto& operand : expr.operands) joined.parts.push_back(condition(operand));
    return joined;
  };
  switch (expr.kind) {
  case ExprKind::True: return "true";
  case ExprKind::False: return "false";
  case ExprKind::Is:
  case ExprKind::IsNot: return comparison(expr);
  case ExprKind::Not: return join("not");
  case ExprKind::And: return join("and");
  case ExprKind::Or: return join("or");
  case ExprKind::Implies: return join("=>");
  }
  std::unreachable();
}

Form Scope::effects(const Effects& all) {
  std::vector<Form> forms;
  std::set<std::string> set;
  for (const auto& effect : all) {
    const auto state = stateOf(effect.resource, effect.state);
    if (!set.insert(effect.resource.text).second)
      errors.push_back({effect.resource.place,
                        fmt::format("`{}` is set twice in one step", effect.resource.text)});
    const auto known = resources.find(effect.resource.text);
    if (known != resources.end()) forms.push_back(list(known->second.name, state));
  }
  return forms.size() == 1 ? forms.front() : Form(std::move(forms));
}

} // namespace proskill::bridge::rl
