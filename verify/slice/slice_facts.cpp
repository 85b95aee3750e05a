#include "verify/slice/slice_facts.h"

#include "verify/model/nodes.h"
#include "verify/reduce/idle_tests.h"
#include "verify/reduce/path_facts.h"

#include <algorithm>
#include <map>
#include <ranges>

namespace proskill::verify {

namespace {

Bits readBy(const System& system, NodeId node) {
  Bits cells;
  addReads(system, node, cells);
  return cells;
}

/// Splits guards into conjuncts, and numbers these.
class GuardReader {
public:
  GuardReader(System& of, std::vector<Conjunct>& to, LimitWatch& watch)
      : system(of), nodes(of), conjuncts(to), limits(watch) {}

  std::vector<ConjunctId> conjunctsOf(NodeId guard) {
    std::vector<ConjunctId> all;
    for (auto node : divided(guard, false)) all.push_back(numberOf(node));
    return all;
  }

private:
  ConjunctId numberOf(NodeId node) {
    const auto [entry, isNew] = known.try_emplace(node, static_cast<ConjunctId>(conjuncts.size()));
    if (!isNew) return entry->second;
    Conjunct made{{node, readBy(system, node)}, {}};
    for (auto part : divided(node, true)) made.parts.push_back({part, readBy(system, part)});
    conjuncts.push_back(std::move(made));
    return entry->second;
  }

  std::vector<NodeId> divided(NodeId node, bool alsoOr) {
    std::vector<NodeId> all;
    divide(node, false, alsoOr, all);
    return all;
  }

  /// \param alsoOr whether the negation of a disjunction counts as a conjunction
  void divide(NodeId id, bool isNegated, bool alsoOr, std::vector<NodeId>& all) {
    limits.check();
    const Node node = system.nodes[id];
    if (node.op == NodeOp::Not && (alsoOr || isNegated))
      return divide(node.a, !isNegated, alsoOr, all);
    if (node.op == (isNegated ? NodeOp::Or : NodeOp::And)) {
      divide(node.a, isNegated, alsoOr, all);
      divide(node.b, isNegated, alsoOr, all);
      return;
    }
    if (!isNegated && node.op == NodeOp::Number && node.number != 0) return;
    all.push_back(isNegated ? nodes.negation(id) : id);
  }

  System& system;
  Nodes nodes;
  std::vector<Conjunct>& conjuncts;
  LimitWatch& limits;
  std::map<NodeId, ConjunctId> known;
};

/// Adds the cells of a test or failure in the code of a path, which only decides about these events
/// unless they are null.
void addTest(const System& system, NodeId node, const Bits* events, PathFacts& facts) {
  const Bits cells = readBy(system, node);
  facts.tested |= cells;
  if (events)
    facts.eventTests.push_back({cells, *events});
  else
    facts.decisive |= cells;
}

/// Adds the cells on which the branches and failures of a path's code depend.
void addTests(const System& system, const Path& path, PathFacts& facts) {
  std::map<std::size_t, Bits> idle; // by instruction: events
  for (auto& test : idleTests(system, path)) idle.emplace(test.first, std::move(test.events));
  for (std::size_t i = 0; i < path.code.size(); ++i) switch (path.code[i].kind) {
    case InstructionKind::On:
    case InstructionKind::JumpUnless:
    case InstructionKind::Fail: {
      const auto events = idle.find(i);
      addTest(system, path.code[i].node, events == idle.end() ? nullptr : &events->second, facts);
      break;
    }
    case InstructionKind::Assign:
    case InstructionKind::Store:
    case InstructionKind::Jump:
    case InstructionKind::Tag:
    case InstructionKind::Origin:
    case InstructionKind::To:
    case InstructionKind::Loop: break;
    }
}

/// Whether a path changes neither the location nor the clocks of its instance.
bool changesNothing(const System& system, const SliceFacts& facts, PathId id) {
  const Path& path = system.paths[id];
  const auto isTimed = [&](PathId other) {
    return system.paths[other].location == path.location &&
           std::ranges::any_of(facts.paths[other].transitions, [&](TransitionId transition) {
             return system.transitions[transition].clock != kNone;
           });
  };
  return std::ranges::all_of(facts.paths[id].targets,
                             [&](std::uint32_t to) { return to == path.location; }) &&
         (path.loops || std::ranges::none_of(facts.pathsOf[path.instance], isTimed));
}

/// Computes the cells that an instance may read after each of its paths.
void findReadLater(const System& system, InstanceId instance, SliceFacts& facts,
                   LimitWatch& limits) {
  const auto& own = facts.pathsOf[instance];
  std::vector<Bits> from(system.instances[instance].locations.size());
  for (auto id : own) {
    from[system.paths[id].location] |= system.paths[id].guardReads;
    from[system.paths[id].location] |= system.paths[id].reads;
  }
  for (bool grew = true; grew;) {
    grew = false;
    for (auto id : own | std::views::reverse) {
      limits.check();
      Bits& later = facts.paths[id].readLater;
      for (auto to : facts.paths[id].targets) later |= from[to];
      Bits& here = from[system.paths[id].location];
      grew = grew || !later.isWithin(here);
      here |= later;
    }
  }
}

} // namespace

SliceFacts::SliceFacts(System& system, LimitWatch& limits)
    : pathsOf(system.instances.size()), writers(system.cells.size()) {
  GuardReader guards(system, conjuncts, limits);
  for (PathId i = 0; i < system.paths.size(); ++i) {
    const Path& path = system.paths[i];
    PathFacts& facts = paths.emplace_back();
    facts.guard = guards.conjunctsOf(path.guard);
    facts.targets = targetsOf(path);
    addTests(system, path, facts);
    for (const auto& assignment : path.assignments)
      facts.assigned.push_back(readBy(system, assignment.value));
    pathsOf[path.instance].push_back(i);
    path.writes.each([&](CellId cell) { writers[cell].insert(path.instance); });
    if (system.instances[path.instance].locations.size() > 1) moving.insert(path.instance);
  }
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    TransitionFacts& facts = transitions.emplace_back();
    facts.guard = guards.conjunctsOf(system.transitions[i].guard);
    for (auto part : system.transitions[i].parts) {
      facts.ownLocations.insert(system.instances[system.paths[part].instance].location);
      paths[part].transitions.push_back(i);
      if (system.transitions[i].urgent || system.transitions[i].clock != kNone)
        timed.insert(system.paths[part].instance);
    }
  }
  for (PathId i = 0; i < paths.size(); ++i)
    paths[i].changesNothing = verify::changesNothing(system, *this, i);
  for (InstanceId i = 0; i < system.instances.size(); ++i) findReadLater(system, i, *this, limits);
}

} // namespace proskill::verify
