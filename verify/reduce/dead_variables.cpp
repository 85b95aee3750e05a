#include "verify/reduce/dead_variables.h"

#include "verify/model/nodes.h"
#include "verify/reduce/urgent_cycles.h"

#include <algorithm>

namespace proskill::verify {

namespace {

class RelevanceSearch {
public:
  RelevanceSearch(const System& of, const std::vector<Goal>& asked, LimitWatch& watch)
      : system(of), goals(asked), limits(watch), pathsOf(of.instances.size()) {
    for (PathId i = 0; i < system.paths.size(); ++i) pathsOf[system.paths[i].instance].push_back(i);
  }

  Relevance run() {
    observed = eventsOf(system, goals);
    for (const auto& goal : goals) addReads(system, goal.condition, relevant.cells);
    const Bits skipped = watching();
    for (InstanceId i = 0; i < system.instances.size(); ++i)
      if (!skipped.contains(i)) keep(i);
    for (const auto& transition : system.transitions) // senders on one port have to agree
      if (transition.parts.size() > 1) addReads(system, transition.guard, relevant.cells);
    while (grow()) {
    }
    for (TransitionId i = 0; i < system.transitions.size(); ++i)
      for (auto part : system.transitions[i].parts)
        if (!kept.contains(system.paths[part].instance)) relevant.dropped.insert(i);
    return std::move(relevant);
  }

private:
  void keep(InstanceId instance) {
    kept.insert(instance);
    relevant.cells.insert(system.instances[instance].location);
  }

  /// Whether a process could be skipped, considering it alone, but for its cycles: it synchronises
  /// with nobody, no goal asks for what it does, and it can neither fail nor force a step after
  /// some time.
  [[nodiscard]] bool maySkip(InstanceId instance) const {
    for (auto id : pathsOf[instance]) {
      const Path& path = system.paths[id];
      const bool isForced = path.wait && path.wait->upper && path.wait->upper != 0;
      if (path.port != kNone || path.mayFail || isForced) return false;
      for (const auto& instruction : path.code)
        if (instruction.event != kNone && observed.contains(instruction.event)) return false;
    }
    return !relevant.cells.contains(system.instances[instance].location);
  }

  /// Finds the processes that only watch: they cannot stop time by urgent steps without end and, if
  /// deadlocks are asked for, end themselves. What conditions on urgent steps read must be written
  /// by processes that are not skipped, or else those that are might move each other for ever.
  [[nodiscard]] Bits watching() const {
    Bits found;
    Bits changing;
    for (InstanceId i = 0; i < system.instances.size(); ++i) {
      if (!maySkip(i)) continue;
      found.insert(i);
      for (auto id : pathsOf[i]) changing |= system.paths[id].writes;
    }
    const bool mustEnd = std::ranges::any_of(
        goals, [](const auto& goal) { return goal.kind == GoalKind::Deadlock; });
    Bits(found).each([&](InstanceId i) {
      if (mustEnd ? hasCycle(system, pathsOf[i], limits)
                  : mayRepeatAlone(system, urgentOf(i), changing, limits))
        found.erase(i);
    });
    return found;
  }

  [[nodiscard]] std::vector<PathId> urgentOf(InstanceId instance) const {
    auto paths = pathsOf[instance];
    std::erase_if(
        paths, [&](PathId id) { return !system.paths[id].wait || !system.paths[id].wait->upper; });
    return paths;
  }

  /// A round of the fixed point: adds what relevant parts are computed from, and who writes that.
  bool grow() {
    const Bits cellsBefore = relevant.cells;
    const Bits keptBefore = kept;
    for (const auto& path : system.paths) {
      limits.check();
      if (!kept.contains(path.instance)) {
        if (path.writes.meets(relevant.cells)) keep(path.instance);
        continue;
      }
      addReads(system, path.guard, relevant.cells);
      for (const auto& instruction : path.code)
        if (instruction.kind == InstructionKind::On ||
            instruction.kind == InstructionKind::JumpUnless)
          addReads(system, instruction.node, relevant.cells);
      for (const auto& assignment : path.assignments)
        if (assignment.checked || path.mayFail || relevant.cells.contains(assignment.target))
          addReads(system, assignment.value, relevant.cells);
    }
    return !(relevant.cells == cellsBefore) || !(kept == keptBefore);
  }

  const System& system;
  const std::vector<Goal>& goals;
  LimitWatch& limits;
  std::vector<std::vector<PathId>> pathsOf; ///< by instance
  Relevance relevant;
  Bits observed; ///< events
  Bits kept;     ///< instances
};

} // namespace

Relevance findRelevant(const System& system, const std::vector<Goal>& goals, LimitWatch& limits) {
  return RelevanceSearch(system, goals, limits).run();
}

Relevance everything(const System& system) {
  Relevance all;
  for (CellId i = 0; i < system.cells.size(); ++i) all.cells.insert(i);
  return all;
}

} // namespace proskill::verify
