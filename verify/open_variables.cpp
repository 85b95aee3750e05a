#include "verify/open_variables.h"

#include "verify/evaluate.h"
#include "verify/nodes.h"
#include "verify/path_facts.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace proskill::verify {

namespace {

/// The choices of values for all open variables together are at most this many.
constexpr std::size_t kMostChoices = 1024;

/// Cells that may not be open: a goal's condition sees them, or a clock starts and stops with them.
Bits closedCells(const System& system, const std::vector<Goal>& goals) {
  Bits closed;
  for (const auto& goal : goals)
    if (goal.kind == GoalKind::Condition) addReads(system, goal.condition, closed);
  for (const auto& transition : system.transitions)
    if (transition.clock != kNone) closed |= transition.guardReads;
  return closed;
}

/// Instances whose clocks a step of theirs would start anew.
Bits clockedInstances(const System& system) {
  Bits all;
  for (const auto& transition : system.transitions)
    if (transition.clock != kNone)
      for (auto part : transition.parts) all.insert(system.paths[part].instance);
  return all;
}

bool isWatched(const System& system, const std::vector<Goal>& goals, const Transition& transition) {
  Bits observed;
  for (const auto& goal : goals) {
    observed |= goal.events;
    addEvents(system, goal.condition, observed);
  }
  bool seen = std::ranges::any_of(transition.events,
                                  [&](EventId event) { return observed.contains(event); });
  for (auto part : transition.parts)
    for (const auto& instruction : system.paths[part].code)
      seen = seen || (instruction.event != kNone && observed.contains(instruction.event));
  return seen;
}

} // namespace

OpenVariables::OpenVariables(const System& of, const std::vector<Goal>& goals, const Bits& dropped)
    : system(&of), setters((of.transitions.size() + 63) / 64), silent(setters) {
  findSetters(goals, dropped);
  forgetMany();
  variableOf.assign(system->transitions.size(), kNone);
  for (std::uint32_t v = 0; v < variables.size(); ++v)
    for (auto setter : variables[v].setters) {
      insert(setters, setter);
      variableOf[setter] = v;
      if (!isWatched(*system, goals, system->transitions[setter])) insert(silent, setter);
    }
  for (TransitionId i = 0; i < system->transitions.size(); ++i) {
    const auto& transition = system->transitions[i];
    auto& read = reads.emplace_back();
    auto& guard = guardReads.emplace_back();
    for (std::uint32_t v = 0; v < variables.size(); ++v) {
      const CellId cell = variables[v].cell;
      const bool guarded = transition.guardReads.contains(cell);
      if (guarded) guard.push_back(v);
      if (guarded || transition.reads.contains(cell)) read.push_back(v);
      if (guarded && !dropped.contains(i)) insert(variables[v].readers, i);
    }
  }
}

bool OpenVariables::isAlwaysPossible(const Transition& transition) const {
  return !transition.urgent && transition.clock == kNone && !transition.tentative &&
         std::ranges::all_of(transition.parts, [&](PathId part) {
           const Path& path = system->paths[part];
           const Node& guard = system->nodes[path.guard];
           return system->instances[path.instance].locations.size() == 1 && !path.mayFail &&
                  guard.op == NodeOp::Number && guard.number != 0;
         });
}

/// The constant that the transition always writes, where it changes only one cell that is told
/// apart.
std::optional<Assignment> OpenVariables::constantOf(const Transition& transition) const {
  std::optional<Assignment> found;
  for (auto part : transition.parts) {
    const Path& path = system->paths[part];
    const auto sure = surelyWritten(path, path.writes);
    for (const auto& assignment : path.assignments) {
      const Cell& cell = system->cells[assignment.target];
      if (cell.mask == 0 || cell.word >= system->storedWords) continue;
      bool constant = system->nodes[assignment.value].op == NodeOp::Number && !assignment.checked;
      bool always = std::ranges::all_of(
          sure, [&](const auto& end) { return end.second.contains(assignment.target); });
      bool same =
          !found || (found->target == assignment.target && found->value == assignment.value);
      if (!constant || !always || !same) return std::nullopt;
      found = assignment;
    }
  }
  return found;
}

void OpenVariables::findSetters(const std::vector<Goal>& goals, const Bits& dropped) {
  const Bits closed = closedCells(*system, goals);
  const Bits clocked = clockedInstances(*system);
  std::map<CellId, Variable> byCell;
  for (TransitionId i = 0; i < system->transitions.size(); ++i) {
    const auto& transition = system->transitions[i];
    if (dropped.contains(i) || !isAlwaysPossible(transition) || transition.consumed.meets(clocked))
      continue;
    auto constant = constantOf(transition);
    if (!constant || closed.contains(constant->target)) continue;
    Variable& variable = byCell[constant->target];
    const std::int64_t value = system->nodes[constant->value].number;
    if (std::ranges::find(variable.values, value) != variable.values.end()) continue;
    variable.cell = constant->target;
    variable.values.push_back(value);
    variable.setters.push_back(i);
    variable.readers.assign(setters.size(), 0);
  }
  for (auto& [_, variable] : byCell)
    if (variable.values.size() > 1) variables.push_back(std::move(variable));
}

/// Those with the most values are kept, as long as there are not too many choices in all.
void OpenVariables::forgetMany() {
  std::ranges::stable_sort(variables, std::greater{},
                           [](const auto& variable) { return variable.values.size(); });
  std::size_t choices = 1;
  std::erase_if(variables, [&](const Variable& variable) {
    if (choices * variable.values.size() > kMostChoices) return true;
    choices *= variable.values.size();
    return false;
  });
}

bool OpenVariables::staysWithin(TransitionId transition, const Word* state) const {
  return variableOf[transition] != kNone && valueOf(variableOf[transition], state).has_value();
}

std::optional<std::uint32_t> OpenVariables::valueOf(std::uint32_t index, const Word* state) const {
  const Variable& variable = variables[index];
  auto found = std::ranges::find(variable.values, readCell(*system, variable.cell, state));
  if (found == variable.values.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - variable.values.begin());
}

void OpenVariables::set(std::uint32_t variable, std::uint32_t value, Word* state) const {
  writeCell(*system, variables[variable].cell, variables[variable].values[value], state);
}

std::vector<TransitionId> OpenVariables::normalise(Word* state, TransitionSet& enabled,
                                                   const Enabling& enabling) const {
  std::vector<TransitionId> steps;
  for (std::uint32_t v = 0; v < variables.size(); ++v) {
    if (valueOf(v, state).value_or(0) == 0) continue;
    set(v, 0, state);
    steps.push_back(variables[v].setters[0]);
    enabling.refresh(variables[v].readers, state, enabled);
  }
  return steps;
}

std::vector<TransitionId> OpenVariables::between(const Word* from, const Word* to) const {
  std::vector<std::uint32_t> which(variables.size());
  std::iota(which.begin(), which.end(), 0U);
  return between(from, to, which);
}

std::vector<TransitionId> OpenVariables::between(const Word* from, const Word* to,
                                                 std::span<const std::uint32_t> which) const {
  std::vector<TransitionId> steps;
  for (auto v : which) {
    auto wanted = valueOf(v, to);
    if (wanted && wanted != valueOf(v, from)) steps.push_back(variables[v].setters[*wanted]);
  }
  return steps;
}

bool OpenVariables::calm(Word* state, const TransitionSet& enabled,
                         const Enabling& enabling) const {
  std::vector<TransitionId> unsure;
  Bits which;
  bool firm = false;
  enabling.eachUrgentHere(state, [&](TransitionId id) {
    if (guardReads[id].empty()) {
      firm = firm || contains(enabled, id);
      return;
    }
    unsure.push_back(id);
    for (auto v : guardReads[id]) which.insert(v);
  });
  if (firm) return false;
  std::vector<std::uint32_t> tried;
  which.each([&](std::uint32_t v) { tried.push_back(v); });
  return eachChoice(tried, state, [&] {
    return std::ranges::none_of(unsure,
                                [&](TransitionId id) { return isEnabled(*system, id, state); });
  });
}

} // namespace proskill::verify
