#include "verify/slice/slicer.h"

#include "verify/laid_out.h"
#include "verify/model/step_copies.h"
#include "verify/model/value_bounds.h"
#include "verify/reduce/idle_tests.h"
#include "verify/reduce/path_facts.h"

#include <algorithm>
#include <ranges>

namespace proskill::verify {

std::vector<TransitionId> Slice::inWhole(std::vector<TransitionId> steps) const {
  for (auto& step : steps) step = original[step];
  return steps;
}

Bits Slice::punctual() const {
  Bits found;
  for (TransitionId i = 0; i < original.size(); ++i)
    if (!late.contains(i)) found.insert(original[i]);
  return found;
}

Slicer::Slicer(const System& system, LimitWatch& watch)
    : base(checkedCopy(system, watch)),
      limits(watch),
      facts(base, watch),
      shell(withoutSteps(base)),
      laidOut(laidOutCopy(base, watch)),
      waits(laidOut, watch) {}

bool Slicer::canDecide(const Goal& goal) {
  switch (goal.kind) {
  case GoalKind::Events:
  case GoalKind::Condition:
  case GoalKind::Error: return !goal.ofRuns;
  case GoalKind::Deadlock:
  case GoalKind::Stuck:
  case GoalKind::Run:
  case GoalKind::Lost:
  case GoalKind::Longest:
  case GoalKind::Shortest:
  case GoalKind::Unsupported: return false;
  }
  std::unreachable();
}

/// Whether no time passes while the condition is false. Includes conditions on values that may not
/// exist.
bool Slicer::isInstant(ConjunctId id) {
  const auto [entry, isNew] = instants.try_emplace(id, false);
  if (isNew) entry->second = !mayFail(base, facts.conjuncts[id].whole.node) && lasting(id).empty();
  return entry->second;
}

std::vector<const Condition*> Slicer::lasting(ConjunctId id) {
  std::vector<const Condition*> found;
  const auto known = instants.find(id);
  if (known != instants.end() && known->second) return found;
  for (const auto& part : facts.conjuncts[id].parts)
    if (!waits.isInstant(part.node)) found.push_back(&part);
  return found;
}

// --- Relevance

std::size_t Slicer::Cone::size() const {
  std::size_t total = 0;
  for (const auto* part : {&instances, &cells, &shared, &observed, &kept, &relevant, &instant})
    total += part->count();
  return total;
}

Bits Slicer::cone(const SliceSeeds& seeds) { return movingOf(coneOf(seeds)); }

std::optional<Bits> Slicer::coneWithin(const SliceSeeds& seeds, std::size_t most) {
  Cone cone;
  begin(seeds, cone);
  if (!growsWithin(most, cone)) return std::nullopt;
  return movingOf(cone);
}

Bits Slicer::movingOf(const Cone& cone) const {
  Bits found = cone.instances;
  found &= facts.moving;
  return found;
}

/// Adds what influences the cone until nothing is left to add, or more instances move.
/// \return whether nothing is left
bool Slicer::growsWithin(std::size_t most, Cone& cone) {
  for (std::size_t before = 0; before != cone.size();) {
    before = cone.size();
    grow(cone);
    if (movingOf(cone).count() > most) return false;
  }
  return true;
}

Slicer::Cone Slicer::coneOf(const SliceSeeds& seeds) {
  Cone cone;
  begin(seeds, cone);
  (void)growsWithin(SIZE_MAX, cone);
  for (const auto& instance : base.instances) cone.own.emplace_back().insert(instance.location);
  cone.cells.each([&](CellId cell) {
    if (cone.reader[cell] != kNone) cone.own[cone.reader[cell]].insert(cell);
  });
  return cone;
}

void Slicer::begin(const SliceSeeds& seeds, Cone& cone) const {
  cone.reader.assign(base.cells.size(), kNone);
  cone.loose = seeds.loose;
  cone.known = seeds.cells;
  cone.isExact = !seeds.steps.empty();
  seeds.steps.each([&](TransitionId id) { observe(id, cone); });
  bool ofErrors = false;
  for (const auto* goal : seeds.goals) {
    addReads(base, goal->condition, cone.shared);
    addEvents(base, goal->condition, cone.events);
    cone.events |= goal->events;
    ofErrors = ofErrors || goal->kind == GoalKind::Error;
  }
  cone.cells = cone.shared;
  if (cone.events.empty() && !ofErrors) return;
  for (TransitionId i = 0; i < base.transitions.size(); ++i)
    if (mayPass(base, base.transitions[i], cone.events) || (ofErrors && mayBeAnError(base, i)))
      observe(i, cone);
}

void Slicer::observe(TransitionId id, Cone& cone) const {
  for (auto part : base.transitions[id].parts) {
    cone.observed.insert(part);
    cone.instances.insert(base.paths[part].instance);
  }
}

void Slicer::need(const Bits& cells, InstanceId reader, Cone& cone) {
  cone.cells |= cells;
  cells.each([&](CellId cell) {
    if (cone.reader[cell] == kNone) cone.reader[cell] = reader;
    if (cone.reader[cell] != reader) cone.shared.insert(cell);
  });
}

/// A round of the fixed point: adds the writers of relevant cells, their relevant paths, and what
/// these read.
void Slicer::grow(Cone& cone) {
  cone.cells.each([&](CellId cell) { cone.instances |= facts.writers[cell]; });
  const Bits instances = cone.instances;
  instances.each([&](InstanceId instance) { sortPaths(instance, cone); });
  cone.kept.each([&](PathId path) {
    limits.check();
    needCode(path, cone);
    for (auto id : facts.paths[path].transitions) needGuard(id, cone);
  });
  needInstants(cone);
}

/// A cell that only the instance itself reads is relevant only as long as it may read it later.
bool Slicer::writesWhatMatters(PathId id, const Cone& cone) const {
  const Path& path = base.paths[id];
  if (path.writes.meets(cone.shared)) return true;
  if (!path.writes.meets(cone.cells)) return false;
  bool matters = false;
  path.writes.each([&](CellId cell) {
    const auto reader = cone.reader[cell];
    matters = matters || (reader != kNone &&
                          (reader != path.instance || facts.paths[id].readLater.contains(cell)));
  });
  return matters;
}

/// Classifies the paths of an instance: the slice contains those that may lead to something
/// relevant, and those that make that impossible.
void Slicer::sortPaths(InstanceId instance, Cone& cone) const {
  std::vector<bool> leads(base.instances[instance].locations.size());
  const bool allMatter =
      cone.isExact && (facts.moving.contains(instance) || facts.timed.contains(instance));
  const auto matters = [&](PathId id) {
    if (allMatter) return true;
    const auto leadsOn = [&](auto to) { return to != base.paths[id].location && leads[to]; };
    return cone.observed.contains(id) || writesWhatMatters(id, cone) ||
           std::ranges::any_of(facts.paths[id].targets, leadsOn);
  };
  for (bool grew = true; grew;) {
    grew = false;
    for (auto id :
         facts.pathsOf[instance] | std::views::reverse) { // usually the order of locations
      limits.check();
      if (leads[base.paths[id].location] || !matters(id)) continue;
      grew = leads[base.paths[id].location] = true;
    }
  }
  for (auto id : facts.pathsOf[instance]) {
    if (!leads[base.paths[id].location]) continue;
    const bool isRelevant = matters(id);
    if (!isRelevant && facts.paths[id].changesNothing) continue;
    cone.kept.insert(id);
    if (isRelevant) cone.relevant.insert(id);
    for (auto transition : facts.paths[id].transitions)
      if (isRelevant || base.transitions[transition].parts.size() > 1) observe(transition, cone);
  }
}

/// Adds what determines whether the transition is possible. Whether an instance reaches an end
/// without relevant paths is irrelevant, unless time depends on it; a condition that is false only
/// for an instant may be omitted.
void Slicer::needGuard(TransitionId id, Cone& cone) {
  const Transition& transition = base.transitions[id];
  const bool isPlain = transition.clock == kNone && !transition.fails;
  if (isPlain && !cone.relevant.contains(transition.parts.front())) return;
  for (auto conjunct : facts.transitions[id].guard) {
    const Bits& cells = facts.conjuncts[conjunct].whole.cells;
    if (cells.isWithin(facts.transitions[id].ownLocations) || isLoose(id, cone)) continue;
    if (isPlain && isInstant(conjunct))
      cone.instant.insert(conjunct);
    else if (!isOmitted(conjunct, id, cone))
      for (auto part : transition.parts) need(cells, base.paths[part].instance, cone);
  }
}

/// Whether the conditions of the transition do not matter.
bool Slicer::isLoose(TransitionId id, const Cone& cone) const {
  const Transition& transition = base.transitions[id];
  return transition.clock == kNone && !transition.fails &&
         std::ranges::all_of(transition.parts, [&](PathId part) {
           return cone.loose.contains(base.paths[part].instance);
         });
}

/// Whether the slice is made without the condition of the step.
bool Slicer::isOmitted(ConjunctId conjunct, TransitionId of, const Cone& cone) const {
  return cone.known && !base.transitions[of].fails &&
         !facts.conjuncts[conjunct].whole.cells.isWithin(*cone.known);
}

void Slicer::needCode(PathId id, Cone& cone) const {
  const Path& path = base.paths[id];
  Bits cells = facts.paths[id].decisive;
  for (const auto& test : facts.paths[id].eventTests)
    if (test.events.meets(cone.events)) cells |= test.cells;
  for (std::size_t i = 0; i < path.assignments.size(); ++i) {
    const auto& assignment = path.assignments[i];
    if (assignment.checked || path.mayFail || cone.cells.contains(assignment.target))
      cells |= facts.paths[id].assigned[i];
  }
  need(cells, path.instance, cone);
}

/// Adds those parts of instant conditions that involve no other moving instance.
void Slicer::needInstants(Cone& cone) const {
  cone.instant.each([&](ConjunctId conjunct) {
    for (const auto& part : facts.conjuncts[conjunct].parts) {
      limits.check();
      Bits from;
      part.cells.each([&](CellId cell) { from |= facts.writers[cell]; });
      from &= facts.moving;
      if (!from.isWithin(cone.instances)) continue;
      cone.cells |= part.cells;
      cone.shared |= part.cells;
    }
  });
}

// --- The slice

/// The cells whose values are, in a state of the slice, those of the whole wherever these instances
/// may take a step together. If only one instance reads a cell, the slice omits what is written
/// after it has read it for the last time; so others would read an old value.
Bits Slicer::currentFor(const Bits& moving, const Cone& cone) const {
  Bits current = cone.shared;
  const bool isAlone = moving.count() == 1; // otherwise the reader is only one of them
  moving.each([&](InstanceId instance) {
    if (isAlone) current |= cone.own[instance];
    current.insert(base.instances[instance].location);
  });
  return current;
}

Bits Slicer::instancesOf(TransitionId id) const {
  Bits moving;
  for (auto part : base.transitions[id].parts) moving.insert(base.paths[part].instance);
  return moving;
}

/// The conjunction of those parts that read nothing else.
NodeId Slicer::guardWithin(const std::vector<ConjunctId>& guard, const Bits& known,
                           Nodes& nodes) const {
  NodeId made = nodes.number(1);
  const auto add = [&](const Condition& condition) {
    const bool isKnown = condition.cells.isWithin(known);
    if (isKnown) made = nodes.both(made, condition.node);
    return isKnown;
  };
  for (auto conjunct : guard)
    if (!add(facts.conjuncts[conjunct].whole))
      std::ranges::for_each(facts.conjuncts[conjunct].parts, add);
  return made;
}

/// Whether the slice may take a step later than the whole has to: a condition that the slice omits
/// decides since when the step is due.
bool Slicer::mayBeLate(TransitionId id, const Bits& current, const Cone& cone) {
  const Transition& transition = base.transitions[id];
  if (!transition.urgent && transition.clock == kNone) return false;
  if (!cone.known && cone.relevant.contains(transition.parts.front()) && !isLoose(id, cone))
    return false;
  return !std::ranges::all_of(facts.transitions[id].guard, [&](ConjunctId conjunct) {
    return facts.conjuncts[conjunct].whole.cells.isWithin(current) ||
           (transition.clock == kNone && isInstant(conjunct));
  });
}

Transition Slicer::cut(TransitionId id, const Cone& cone, Nodes& nodes, Slice& made) {
  Transition transition = base.transitions[id];
  const Bits current = currentFor(instancesOf(id), cone);
  if (mayBeLate(id, current, cone)) {
    made.late.insert(static_cast<std::uint32_t>(made.original.size()));
    transition.urgent = false;
    transition.interval = {};
    transition.clock = kNone;
  }
  transition.guard = guardWithin(facts.transitions[id].guard, current, nodes);
  transition.guardReads &= current;
  return transition;
}

Path Slicer::cutPath(PathId id, const Cone& cone, Nodes& nodes) const {
  Path path = withoutIdleTests(base, base.paths[id], cone.events);
  Bits moving;
  for (auto transition : facts.paths[id].transitions) moving |= instancesOf(transition);
  const Bits current = currentFor(moving, cone);
  path.guard = guardWithin(facts.paths[id].guard, current, nodes);
  path.guardReads &= current;
  return path;
}

Slice Slicer::slice(const SliceSeeds& seeds) {
  const Cone cone = coneOf(seeds);
  shell.nodes = base.nodes;
  Slice made{shell, {}, {}};
  System& system = made.system;
  Nodes nodes(system);
  StepCopies steps(base, system);
  for (TransitionId id = 0; id < base.transitions.size(); ++id) {
    limits.check();
    const auto isKept = [&](PathId part) { return cone.kept.contains(part); };
    if (!std::ranges::all_of(base.transitions[id].parts, isKept)) continue;
    steps.add(id, cut(id, cone, nodes, made),
              [&](PathId path) { return cutPath(path, cone, nodes); });
    made.original.push_back(id);
  }
  return made;
}

} // namespace proskill::verify
