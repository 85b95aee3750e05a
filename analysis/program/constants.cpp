#include "analysis/program/constants.h"

#include <algorithm>

namespace proskill::analysis {

namespace {

using syntax::ConstantValues;

/// The constants with a number, but those whose names are also values, tags and the like.
ConstantValues valuesOf(const Program& program) {
  ConstantValues values;
  for (const auto& constant : program.constants.all)
    if (constant.form->name && constant->value.kind == syntax::ExprKind::Number)
      values.try_emplace(constant.name(), &constant->value);
  if (values.empty()) return values;
  for (const auto& variable : program.stateVariables.all) {
    values.erase(variable.name());
    for (const auto& value : variable.nodeAsRead().states) values.erase(value.text);
  }
  for (const auto& definition : program.skills.all) {
    const auto& skill = definition.nodeAsRead();
    for (const auto& outcome : skill.successes) values.erase(outcome.tag.text);
    for (const auto& outcome : skill.failures) values.erase(outcome.tag.text);
    for (const auto& invariant : skill.invariants) values.erase(invariant.tag.text);
  }
  return values;
}

template <class Node>
void fillIn(const syntax::ConstantFiller& filler, Program& program, Table<Node>& table) {
  for (Definition<Node>& it : table.all) {
    const std::string_view text = program.files[it.file].document.text();
    const auto range = it.form->range;
    if (auto filled = filler.filled(*it.form, text.substr(range.begin, range.length())))
      it.form = &program.filled.emplace_back(*std::move(filled));
  }
}

} // namespace

void fillInConstants(Program& program) {
  program.constantValues = valuesOf(program);
  if (program.constantValues.empty()) return;
  const syntax::ConstantFiller filler(program.constantValues);
  fillIn(filler, program, program.stateVariables);
  fillIn(filler, program, program.events);
  fillIn(filler, program, program.skills);
  fillIn(filler, program, program.resources);
  fillIn(filler, program, program.properties);
  fillIn(filler, program, program.environments);
}

bool haveSameConstants(const Program& a, const Program& b) {
  return a.constantValues.size() == b.constantValues.size() &&
         std::ranges::all_of(a.constantValues, [&](const auto& each) {
           const auto other = b.constantValues.find(each.first);
           return other != b.constantValues.end() && other->second->number == each.second->number &&
                  other->second->decimal == each.second->decimal;
         });
}

} // namespace proskill::analysis
