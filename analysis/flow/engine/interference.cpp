#include "analysis/flow/engine/interference.h"

#include <algorithm>

namespace proskill::analysis::flow {

Interference::Interference(const Variables& variables)
    : variables(variables), all(variables.size()) {}

ValueSet Interference::added(ProcessId process, VariableId variable, unsigned from, ValueSet to) {
  auto writer = all[variable].writers.try_emplace(process, variables[variable].domain.size()).first;
  ValueSet before = writer->second.from(from);
  if (!writer->second.add(from, to)) return {};
  return writer->second.from(from) - before;
}

std::vector<View*> Interference::grown(ProcessId process, VariableId variable, unsigned from,
                                       unsigned to) {
  PerVariable& here = all[variable];
  auto [entry, isNew] = here.without.try_emplace({from, to});
  std::vector<View*>& without = entry->second;
  if (isNew)
    for (auto& [number, view] : here.views) without.push_back(&view);
  auto gone = std::ranges::stable_partition(
      without, [process](const View* view) { return !view->processes->contains(process); });
  std::vector<View*> views(gone.begin(), gone.end());
  without.erase(gone.begin(), gone.end());
  return views;
}

View& Interference::of(const IdSet& processes, VariableId variable) {
  auto set = known.try_emplace(processes, known.size()).first;
  PerVariable& here = all[variable];
  auto found = here.views.find(set->second);
  if (found != here.views.end()) return found->second;
  View view{.processes = &set->first, .relation = Relation(variables[variable].domain.size())};
  for (const auto& [process, relation] : here.writers)
    if (processes.contains(process)) view.relation.addAll(relation);
  View& made = here.views.emplace(set->second, std::move(view)).first->second;
  for (auto& [move, without] : here.without)
    if (!made.relation.from(move.first).contains(move.second)) without.push_back(&made);
  return made;
}

} // namespace proskill::analysis::flow
