#include "tests/flow/analysed.h"

#include "tests/support/texts.h"

#include <stdexcept>

namespace proskill::test {

using namespace analysis::flow;

Analysed::Analysed(std::string text) : program(programOfText(std::move(text))) {
  system = std::make_unique<System>(program);
  solver = std::make_unique<Solver>(*system);
}

Analysed::Place Analysed::find(std::string_view statement) const {
  std::string_view text = program.files[0].document.text();
  for (ProcessId id = 0; id < system->size(); ++id) {
    const Process& process = (*system)[id];
    if (!process.graph) continue;
    for (NodeId node = 0; node < process.graph->nodes.size(); ++node) {
      const Node& each = (*process.graph)[node];
      // A branch that ends the skill has a node in the branch, and one where the skill then ends.
      if (!each.statement || process.actions[node].leaver != kNoProcess) continue;
      if (text.substr(each.statement->range.begin).starts_with(statement)) return {id, node};
    }
  }
  throw std::invalid_argument("no such statement: " + std::string(statement));
}

VariableId Analysed::variable(std::string_view name) const {
  for (VariableId id = 0; id < system->variables().size(); ++id)
    if (system->variables().name(id) == name) return id;
  throw std::invalid_argument("no such variable: " + std::string(name));
}

std::string Analysed::at(std::string_view statement, std::string_view name) const {
  Place place = find(statement);
  VariableId id = variable(name);
  auto slot = (*system)[place.process].slots.find(id);
  if (!slot) return "not followed";
  if (!reaches(statement)) return "unreachable";
  return system->variables().words(id, solver->before(place.process, place.node).values[*slot]);
}

bool Analysed::reaches(std::string_view statement) const {
  Place place = find(statement);
  return (*system)[place.process].analysed && solver->reachable(place.process, place.node);
}

std::string Analysed::ever(std::string_view name) const {
  VariableId id = variable(name);
  return system->variables().words(id, solver->ever(id));
}

} // namespace proskill::test
