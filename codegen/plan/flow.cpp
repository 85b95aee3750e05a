#include "codegen/plan/flow.h"

#include <algorithm>

namespace proskill::codegen {
namespace {

bool mayContinue(const BodyState& state) {
  if (!state.statement) return false;
  if (state.statement->kind == syntax::StatementKind::Parallel)
    return std::ranges::all_of(state.branches, mayReachEnd);
  if (state.statement->kind == syntax::StatementKind::Race)
    return state.branches.empty() || std::ranges::any_of(state.branches, mayReachEnd);
  return true;
}

} // namespace

std::set<std::string_view> statesOnPaths(const BodyAutomaton& body) {
  std::set<std::string_view> found;
  std::vector<std::string_view> todo{body.entry};
  while (!todo.empty()) {
    const auto name = todo.back();
    todo.pop_back();
    const auto state = std::ranges::find(body.states, name, &BodyState::name);
    if (state == body.states.end() || !found.insert(state->name).second) continue;
    todo.insert(todo.end(), state->targets.begin(), state->targets.end());
    if (mayContinue(*state)) todo.push_back(state->next);
  }
  return found;
}

bool mayReachEnd(const BodyAutomaton& body) {
  const auto& last = body.states.back();
  return !last.statement && statesOnPaths(body).contains(last.name);
}

} // namespace proskill::codegen
