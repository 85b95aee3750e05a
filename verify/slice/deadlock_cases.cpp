#include "verify/slice/deadlock_cases.h"

#include "verify/model/value_bounds.h"
#include "verify/slice/slice_search.h"

#include <algorithm>
#include <set>

namespace proskill::verify {

namespace {

Goal conditionGoal(NodeId condition) {
  return {.kind = GoalKind::Condition, .events = {}, .condition = condition};
}

/// The locations that the instance reaches if all of its paths are possible.
Bits reachable(const System& system, const SliceFacts& facts, InstanceId instance) {
  Bits found;
  const CellId cell = system.instances[instance].location;
  found.insert(static_cast<std::uint32_t>(system.cells[cell].initial));
  for (std::uint32_t before = 0; before != found.count();) {
    before = found.count();
    for (auto id : facts.pathsOf[instance])
      if (found.contains(system.paths[id].location))
        for (auto to : facts.paths[id].targets) found.insert(to);
  }
  return found;
}

} // namespace

DeadlockCases::DeadlockCases(Slicer& of) : slicer(of) {}

/// Whether it is possible whenever its guard is true.
bool DeadlockCases::isExactlyGuarded(TransitionId id) const {
  const System& system = slicer.system();
  const Transition& transition = system.transitions[id];
  return !transition.tentative && !transition.fails && !mayFail(system, transition.guard);
}

std::vector<InstanceId> DeadlockCases::instances() {
  std::vector<std::tuple<bool, std::size_t, InstanceId>> found;
  const System& system = slicer.system();
  slicer.moving().each([&](InstanceId instance) {
    const auto waits = waitsOf(instance);
    if (!waits) return;
    const auto start = system.cells[system.instances[instance].location].initial;
    const auto first = waitsAt(instance, static_cast<std::uint32_t>(start));
    found.emplace_back(!first || !first->empty(), waits->size(), instance);
  });
  std::ranges::sort(found);
  std::vector<InstanceId> all;
  for (const auto& one : found) all.push_back(std::get<InstanceId>(one));
  return all;
}

/// Conditions of which one is false while the instance is blocked.
std::optional<DeadlockCases::Conditions> DeadlockCases::waitsOf(InstanceId instance) {
  std::set<NodeId> all;
  bool isKnown = true;
  reachable(slicer.system(), slicer.known(), instance).each([&](std::uint32_t location) {
    const auto here = isKnown ? waitsAt(instance, location) : std::nullopt;
    isKnown = here.has_value();
    if (here) all.insert(here->begin(), here->end());
  });
  if (!isKnown) return std::nullopt;
  return Conditions(all.begin(), all.end());
}

/// Those of one step from the location: the one with the fewest.
std::optional<DeadlockCases::Conditions> DeadlockCases::waitsAt(InstanceId instance,
                                                                std::uint32_t location) {
  std::optional<Conditions> best;
  const SliceFacts& facts = slicer.known();
  for (auto path : facts.pathsOf[instance]) {
    if (slicer.system().paths[path].location != location) continue;
    for (auto id : facts.paths[path].transitions) {
      auto waits = waitsOf(id, instance, location);
      if (waits && (!best || waits->size() < best->size())) best = std::move(waits);
    }
  }
  return best;
}

/// The conditions of a step that may be false in a deadlock. While a condition that is false only
/// for an instant is false, some step is possible.
std::optional<DeadlockCases::Conditions>
DeadlockCases::waitsOf(TransitionId id, InstanceId instance, std::uint32_t location) {
  if (!isExactlyGuarded(id)) return std::nullopt;
  const System& system = slicer.system();
  Bits own;
  own.insert(system.instances[instance].location);
  Conditions found;
  for (auto conjunct : slicer.known().transitions[id].guard)
    for (auto part : slicer.lasting(conjunct))
      if (!part->cells.isWithin(own) &&
          !slicer.instantWaits().holdsAt(part->node, instance, location))
        found.push_back(part->node);
  return found;
}

std::optional<std::vector<PartCase>> DeadlockCases::casesOf(InstanceId instance) {
  const auto waits = waitsOf(instance);
  if (!waits) return std::nullopt;
  std::vector<PartCase> cases;
  for (auto condition : *waits) {
    auto one = caseOf(condition, instance);
    if (!one) return std::nullopt;
    cases.push_back(std::move(*one));
  }
  return cases;
}

std::optional<PartCase> DeadlockCases::caseOf(NodeId condition, InstanceId instance) {
  const NodeId isFalse = Nodes(slicer.system()).negation(condition);
  if (auto made = caseWithin(isFalse, instance, {})) return made;
  Bits loose;
  loose.insert(instance);
  return caseWithin(isFalse, instance, loose);
}

/// The condition is false, and what has an influence on it is blocked: each step of its cone whose
/// guard does not depend on more than the cone.
std::optional<PartCase> DeadlockCases::caseWithin(NodeId isFalse, InstanceId instance,
                                                  const Bits& loose) {
  PartCase made{conditionGoal(isFalse), loose};
  const auto instancesOf = [&](const Goal& goal) {
    return slicer.instances({.goals = {&goal}, .steps = {}, .loose = loose});
  };
  const Bits cone = instancesOf(made.goal);
  Bits moving = cone;
  moving &= slicer.moving();
  if (!isSmallPart(moving, slicer.moving())) return std::nullopt;
  Bits others = cone;
  others.erase(instance);
  Nodes nodes(slicer.system());
  others.each([&](InstanceId other) {
    for (auto isBlocked : blockedSteps(other, others, cone, nodes)) {
      const Goal more = conditionGoal(nodes.both(made.goal.condition, isBlocked));
      if (instancesOf(more).isWithin(cone)) made.goal = more;
    }
  });
  return made;
}

/// For each step of an instance in which no instance but `within` takes part: that it is not
/// possible. Skips steps whose guards are changed by more than the cone.
std::vector<NodeId> DeadlockCases::blockedSteps(InstanceId of, const Bits& within, const Bits& cone,
                                                Nodes& nodes) {
  const System& system = slicer.system();
  std::vector<NodeId> found;
  for (auto path : slicer.known().pathsOf[of])
    for (auto id : slicer.known().paths[path].transitions) {
      const bool isWithin = std::ranges::all_of(system.transitions[id].parts, [&](PathId part) {
        return within.contains(slicer.system().paths[part].instance);
      });
      if (!isWithin || !isExactlyGuarded(id)) continue;
      const NodeId guard = guardOf(id, nodes);
      if (writersOf(guard).isWithin(cone)) found.push_back(nodes.negation(guard));
    }
  return found;
}

Bits DeadlockCases::writersOf(NodeId condition) const {
  Bits cells;
  Bits writers;
  addReads(slicer.system(), condition, cells);
  cells.each([&](CellId cell) { writers |= slicer.known().writers[cell]; });
  return writers;
}

/// The guard without conditions that are false only for an instant.
NodeId DeadlockCases::guardOf(TransitionId id, Nodes& nodes) {
  NodeId made = nodes.number(1);
  for (auto conjunct : slicer.known().transitions[id].guard)
    for (auto part : slicer.lasting(conjunct)) made = nodes.both(made, part->node);
  return made;
}

} // namespace proskill::verify
