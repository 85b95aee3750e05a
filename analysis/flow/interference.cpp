#include "analysis/flow/interference.h"

namespace proskill::analysis::flow {

Interference::Interference(const Variables& variables, std::size_t processes)
    : variables(variables), all(variables.size()) {
  known.emplace(Bits(processes), 0);
}

bool Interference::add(std::size_t process, VariableId variable, unsigned from, ValueSet to) {
  PerVariable& here = all[variable];
  auto writer = here.writers.try_emplace(process, variables[variable].domain.size()).first;
  if (!writer->second.add(from, to)) return false;
  for (auto& [key, view] : here.views)
    if (view.processes->contains(process)) view.relation.add(from, to);
  return true;
}

const Bits* Interference::intern(const Bits& processes) {
  return &known.try_emplace(processes, known.size()).first->first;
}

const Relation& Interference::of(const Bits& processes, VariableId variable) {
  const Bits* set = intern(processes);
  PerVariable& here = all[variable];
  auto found = here.views.find(set);
  if (found != here.views.end()) return found->second.relation;
  View view{set, Relation(variables[variable].domain.size())};
  for (const auto& [process, relation] : here.writers)
    if (set->contains(process)) view.relation.addAll(relation);
  return here.views.emplace(set, std::move(view)).first->second.relation;
}

const Relation* Interference::by(std::size_t process, VariableId variable) const {
  auto found = all[variable].writers.find(process);
  return found == all[variable].writers.end() ? nullptr : &found->second;
}

std::vector<std::size_t> Interference::writers(VariableId variable) const {
  std::vector<std::size_t> result;
  for (const auto& [process, relation] : all[variable].writers) result.push_back(process);
  return result;
}

} // namespace proskill::analysis::flow
