#include "analysis/flow/domain/inputs.h"

#include "analysis/flow/domain/numbers.h"
#include "analysis/names/symbols.h"
#include "analysis/names/types.h"
#include "analysis/names/walk.h"

namespace proskill::analysis::flow {

Inputs::Inputs(const Program& of, const Variables& with) : program(of), variables(with) {
  for (std::size_t skill = 0; skill < program.skills.all.size(); ++skill) declare(skill);
  if (known.empty()) return;
  for (std::size_t skill = 0; skill < program.skills.all.size(); ++skill)
    if (const auto& body = program.skills.all[skill]->body)
      forEachStatement(*body, [&](const syntax::Statement& statement) {
        if (statement.kind == syntax::StatementKind::Call) pass(skill, statement);
      });
  spread();
  const bool isLibrary = mainSkill(program).candidates.empty();
  for (auto& [key, input] : known) {
    const bool isFree = isLibrary && !program.skills.all[key.first]->isComposite();
    if (isFree || any.contains(key)) numbers[key].clear();
    setValues(input, numbers[key]);
  }
}

const Inputs::Input* Inputs::find(std::size_t skill, std::string_view name) const {
  const auto found = known.find({skill, name});
  return found == known.end() ? nullptr : &found->second;
}

void Inputs::declare(std::size_t skill) {
  for (const auto& input : program.skills.all[skill]->inputs) {
    const auto type = program.stateVariables.byName.find(input.type.text);
    if (isTruthValue(input))
      known[{skill, input.name.text}] = {};
    else if (type != program.stateVariables.byName.end())
      known[{skill, input.name.text}] = {
          .type = variables.of(VariableKind::StateVariable, type->second)};
  }
}

void Inputs::pass(std::size_t caller, const syntax::Statement& call) {
  const auto callee = program.skills.byName.find(call.head.text);
  if (callee == program.skills.byName.end()) return;
  for (const auto& input : program.skills.all[callee->second]->inputs)
    for (const auto& argument : call.arguments)
      if (argument.name.text == withoutDollar(input.name).text)
        passValue({caller, argument.value.name.text}, argument.value,
                  {callee->second, input.name.text});
}

void Inputs::passValue(const Key& from, const syntax::Expr& value, const Key& to) {
  const auto input = known.find(to);
  if (input == known.end()) return;
  if (value.kind == syntax::ExprKind::Parameter && known.contains(from))
    passed.emplace_back(from, to);
  else if (const auto number = numberOf(value, input->second))
    numbers[to].insert(*number);
  else
    any.insert(to);
}

std::optional<std::int64_t> Inputs::numberOf(const syntax::Expr& value, const Input& input) const {
  if (!input.type) return truthValue(value);
  if (const auto number = wholeNumber(value)) return number;
  return variables[*input.type].domain.numberOf(value.name.text);
}

/// Repeated until nothing changes, since callers pass on their own inputs.
void Inputs::spread() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [from, to] : passed) {
      const auto before = numbers[to].size();
      numbers[to].insert(numbers[from].begin(), numbers[from].end());
      changed |= numbers[to].size() != before || (any.contains(from) && any.insert(to).second);
    }
  }
}

Span Inputs::allValues(const Input& input) const {
  if (!input.type) return {0, 1};
  const Domain& domain = variables[*input.type].domain;
  return {domain.min(), domain.max()};
}

/// \param given empty: any value
void Inputs::setValues(Input& input, const std::set<std::int64_t>& given) const {
  if (given.empty()) input.values = {allValues(input)};
  for (const auto number : given) input.values.push_back({number, number});
}

} // namespace proskill::analysis::flow
