#include "verify/slice/slicer.h"

#include "verify/reduce/path_facts.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <ranges>

namespace proskill::verify {

namespace {

bool isWithin(const Bits& some, const Bits& all) {
  Bits outside = some;
  outside -= all;
  return outside.empty();
}

void keepOnly(Bits& some, const Bits& all) {
  Bits outside = some;
  outside -= all;
  some -= outside;
}

bool mayFailAtAll(const Path& path) { return path.mayFail || path.fails; }

} // namespace

Slicer::Slicer(const System& system, LimitWatch& watch)
    : base(system),
      nodes(base),
      limits(watch),
      pathsOf(base.instances.size()),
      having(base.paths.size()),
      writers(base.cells.size()),
      laidOut((readGuards(), withStateLayout(base))),
      waits(laidOut, watch) {
  for (PathId i = 0; i < base.paths.size(); ++i) {
    const Path& path = base.paths[i];
    pathsOf[path.instance].push_back(i);
    path.writes.each([&](CellId cell) { writers[cell].insert(path.instance); });
    if (base.instances[path.instance].locations.size() > 1) movingOnes.insert(path.instance);
  }
  for (TransitionId i = 0; i < base.transitions.size(); ++i)
    for (auto part : base.transitions[i].parts) having[part].push_back(i);
  findReadLater();
}

/// By location of each instance: the cells that its paths from there on may read.
void Slicer::findReadLater() {
  for (InstanceId i = 0; i < base.instances.size(); ++i) {
    auto& at = readLater.emplace_back(base.instances[i].locations.size());
    for (auto id : pathsOf[i]) {
      at[base.paths[id].location] |= base.paths[id].guardReads;
      at[base.paths[id].location] |= base.paths[id].reads;
    }
    for (bool grew = true; grew;) {
      grew = false;
      for (auto id : pathsOf[i] | std::views::reverse) {
        limits.check();
        Bits& here = at[base.paths[id].location];
        const Bits before = here;
        for (auto to : targetsOf(base.paths[id])) here |= Bits(at[to]);
        grew = grew || !(here == before);
      }
    }
  }
}

/// The parts of conjuncts are nodes that may be new, so they are made before all else.
void Slicer::readGuards() {
  for (const auto& path : base.paths) split(path.guard, false, false, ofPath.emplace_back());
  for (const auto& transition : base.transitions)
    split(transition.guard, false, false, ofTransition.emplace_back());
  for (const auto& all : ofTransition)
    for (auto conjunct : all)
      if (const auto [entry, isNew] = parts.try_emplace(conjunct); isNew)
        split(conjunct, false, true, entry->second);
}

/// The conditions that a guard, or its negation, is the conjunction of.
/// \param alsoOr whether the negation of a disjunction counts as one
void Slicer::split(NodeId id, bool negated, bool alsoOr, std::vector<NodeId>& all) {
  limits.check();
  const Node node = base.nodes[id];
  if (node.op == NodeOp::Not && (alsoOr || negated)) return split(node.a, !negated, alsoOr, all);
  if (node.op == (negated ? NodeOp::Or : NodeOp::And)) {
    split(node.a, negated, alsoOr, all);
    split(node.b, negated, alsoOr, all);
    return;
  }
  if (!negated && node.op == NodeOp::Number && node.number != 0) return;
  all.push_back(negated ? nodes.negation(id) : id);
}

bool Slicer::canDecide(const Goal& goal) {
  switch (goal.kind) {
  case GoalKind::Events:
  case GoalKind::Condition:
  case GoalKind::Error: return !goal.ofRuns;
  case GoalKind::Deadlock:
  case GoalKind::Stuck:
  case GoalKind::Run:
  case GoalKind::Unsupported: return false;
  }
  std::unreachable();
}

Bits Slicer::readBy(NodeId node) const {
  Bits cells;
  addReads(base, node, cells);
  return cells;
}

Bits Slicer::ownLocations(const Transition& transition) const {
  Bits cells;
  for (auto part : transition.parts)
    cells.insert(base.instances[base.paths[part].instance].location);
  return cells;
}

/// Whether no time passes while the condition is false. Values that may not exist are looked at.
bool Slicer::isInstant(NodeId conjunct) {
  const auto& all = parts.at(conjunct);
  return !mayFail(base, conjunct) &&
         std::ranges::all_of(all, [&](NodeId part) { return waits.isInstant(part); });
}

// --- What matters

Bits Slicer::cone(const Goals& goals) {
  Bits found = coneOf(goals).instances;
  keepOnly(found, movingOnes);
  return found;
}

Slicer::Cone Slicer::coneOf(const Goals& goals) {
  Cone cone;
  begin(goals, cone);
  for (Cone before; !(before == cone);) {
    before = cone;
    grow(cone);
  }
  return cone;
}

void Slicer::begin(const Goals& goals, Cone& cone) const {
  Bits events;
  bool ofErrors = false;
  for (const auto* goal : goals) {
    addReads(base, goal->condition, cone.shared);
    addEvents(base, goal->condition, events);
    events |= goal->events;
    ofErrors = ofErrors || goal->kind == GoalKind::Error;
  }
  cone.cells = cone.shared;
  for (TransitionId i = 0; i < base.transitions.size(); ++i) {
    const auto fails = [&](PathId part) { return mayFailAtAll(base.paths[part]); };
    const auto& transition = base.transitions[i];
    if (mayPass(base, transition, events) ||
        (ofErrors && (transition.fails || std::ranges::any_of(transition.parts, fails))))
      observe(i, cone);
  }
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
    if (cone.reader.try_emplace(cell, reader).first->second != reader) cone.shared.insert(cell);
  });
}

/// One round: who writes what matters, which of its paths matter, and what these read.
void Slicer::grow(Cone& cone) {
  cone.cells.each([&](CellId cell) { cone.instances |= writers[cell]; });
  const Bits instances = cone.instances;
  instances.each([&](InstanceId instance) { sortPaths(instance, cone); });
  const auto needPath = [&](PathId path) {
    limits.check();
    needCode(base.paths[path], cone);
    for (auto id : having[path]) needGuard(id, cone);
  };
  cone.relevant.each(needPath);
  cone.ending.each(needPath);
  needInstants(cone);
}

/// What only the instance itself reads matters only where it may read it later.
bool Slicer::writesWhatMatters(const Path& path, const Cone& cone) const {
  if (path.writes.meets(cone.shared)) return true;
  if (!path.writes.meets(cone.cells)) return false;
  Bits later;
  for (auto to : targetsOf(path)) later |= readLater[path.instance][to];
  bool matters = false;
  path.writes.each([&](CellId cell) {
    const auto reader = cone.reader.find(cell);
    matters = matters || (reader != cone.reader.end() &&
                          (reader->second != path.instance || later.contains(cell)));
  });
  return matters;
}

/// Which paths of an instance are in the slice: those that may lead to what matters, and those that
/// make it impossible.
void Slicer::sortPaths(InstanceId instance, Cone& cone) const {
  std::vector<bool> leads(base.instances[instance].locations.size());
  const auto matters = [&](PathId id) {
    const Path& path = base.paths[id];
    const auto targets = targetsOf(path);
    return cone.observed.contains(id) || writesWhatMatters(path, cone) ||
           std::ranges::any_of(targets, [&](auto to) { return to != path.location && leads[to]; });
  };
  for (bool grew = true; grew;) {
    grew = false;
    for (auto id : pathsOf[instance]) {
      limits.check();
      if (leads[base.paths[id].location] || !matters(id)) continue;
      grew = leads[base.paths[id].location] = true;
    }
  }
  for (auto id : pathsOf[instance]) {
    if (!leads[base.paths[id].location]) continue;
    const bool isRelevant = matters(id);
    if (!isRelevant && changesNothing(id)) continue;
    (isRelevant ? cone.relevant : cone.ending).insert(id);
    if (isRelevant) cone.ending.erase(id);
    for (auto transition : having[id])
      if (isRelevant || base.transitions[transition].parts.size() > 1) observe(transition, cone);
  }
}

/// Whether the path leaves its instance where it is, and all clocks of it as they are.
bool Slicer::changesNothing(PathId id) const {
  const Path& path = base.paths[id];
  const auto targets = targetsOf(path);
  const auto isTimed = [&](PathId other) {
    return base.paths[other].location == path.location &&
           std::ranges::any_of(having[other], [&](TransitionId transition) {
             return base.transitions[transition].clock != kNone;
           });
  };
  return std::ranges::all_of(targets, [&](std::uint32_t to) { return to == path.location; }) &&
         (path.loops || std::ranges::none_of(pathsOf[path.instance], isTimed));
}

/// What decides whether the transition is possible matters. Whether an instance comes to an end at
/// which nothing of it matters does not, unless time depends on it; and a condition that is false
/// for an instant only may be left out.
void Slicer::needGuard(TransitionId id, Cone& cone) {
  const Transition& transition = base.transitions[id];
  const bool isPlain = transition.clock == kNone && !transition.fails;
  if (isPlain && !cone.relevant.contains(transition.parts.front())) return;
  const Bits own = ownLocations(transition);
  for (auto conjunct : ofTransition[id]) {
    Bits cells = readBy(conjunct);
    if (isWithin(cells, own)) continue; // where its instances are
    if (isPlain && isInstant(conjunct))
      cone.instant.insert(conjunct);
    else
      for (auto part : transition.parts) need(cells, base.paths[part].instance, cone);
  }
}

void Slicer::needCode(const Path& path, Cone& cone) const {
  Bits cells;
  for (const auto& instruction : path.code) switch (instruction.kind) {
    case InstructionKind::On:
    case InstructionKind::JumpUnless:
    case InstructionKind::Fail: addReads(base, instruction.node, cells); break;
    case InstructionKind::Assign:
    case InstructionKind::Store:
    case InstructionKind::Jump:
    case InstructionKind::Tag:
    case InstructionKind::Origin:
    case InstructionKind::To:
    case InstructionKind::Loop: break;
    }
  for (const auto& assignment : path.assignments)
    if (assignment.checked || path.mayFail || cone.cells.contains(assignment.target))
      addReads(base, assignment.value, cells);
  need(cells, path.instance, cone);
}

/// Those parts of instant conditions are looked at that bring in no other moving instance.
void Slicer::needInstants(Cone& cone) {
  const Bits conditions = cone.instant;
  conditions.each([&](NodeId conjunct) {
    for (auto part : parts.at(conjunct)) {
      limits.check();
      const Bits cells = readBy(part);
      Bits from;
      cells.each([&](CellId cell) { from |= writers[cell]; });
      keepOnly(from, movingOnes);
      if (!isWithin(from, cone.instances)) continue;
      cone.cells |= cells;
      cone.shared |= cells;
    }
  });
}

// --- The slice

/// The conjunction of those parts that look at nothing else.
NodeId Slicer::guardWithin(const std::vector<NodeId>& conjuncts, const Bits& known, Nodes& made) {
  NodeId guard = made.number(1);
  for (auto conjunct : conjuncts) {
    if (isWithin(readBy(conjunct), known)) {
      guard = made.both(guard, conjunct);
      continue;
    }
    const auto all = parts.find(conjunct);
    if (all == parts.end()) continue;
    for (auto part : all->second)
      if (isWithin(readBy(part), known)) guard = made.both(guard, part);
  }
  return guard;
}

Slice Slicer::slice(const Goals& goals) {
  const Cone cone = coneOf(goals);
  Slice made{base, {}, {}};
  System& system = made.system;
  system.paths.clear();
  system.transitions.clear();
  Nodes newNodes(system);
  std::map<PathId, PathId> numbers;
  for (TransitionId id = 0; id < base.transitions.size(); ++id) {
    limits.check();
    Transition transition = base.transitions[id];
    const auto isIn = [&](PathId part) {
      return cone.relevant.contains(part) || cone.ending.contains(part);
    };
    if (!std::ranges::all_of(transition.parts, isIn)) continue;
    Bits known = cone.cells;
    known |= ownLocations(transition);
    const auto sees = [&](NodeId conjunct) { return isWithin(readBy(conjunct), known); };
    const bool isRelevant = cone.relevant.contains(transition.parts.front());
    if (!isRelevant && transition.urgent && !std::ranges::all_of(ofTransition[id], sees)) {
      made.late.insert(static_cast<std::uint32_t>(made.original.size()));
      transition.urgent = false;
      transition.interval = {};
    }
    transition.guard = guardWithin(ofTransition[id], known, newNodes);
    keepOnly(transition.guardReads, known);
    for (auto& part : transition.parts) {
      const auto [entry, isNew] =
          numbers.try_emplace(part, static_cast<PathId>(system.paths.size()));
      if (isNew) {
        Path path = base.paths[part];
        path.guard = guardWithin(ofPath[part], known, newNodes);
        keepOnly(path.guardReads, known);
        system.paths.push_back(std::move(path));
      }
      part = entry->second;
    }
    if (transition.clock != kNone && base.clocks[transition.clock].transition == id)
      system.clocks[transition.clock].transition = static_cast<TransitionId>(made.original.size());
    system.transitions.push_back(std::move(transition));
    made.original.push_back(id);
  }
  return made;
}

} // namespace proskill::verify
