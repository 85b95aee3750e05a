#include "verify/refine/contraction.h"

#include "verify/model/nodes.h"
#include "verify/model/step_copies.h"
#include "verify/reduce/dead_variables.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <optional>

namespace proskill::verify {

namespace {

/// From a removed location: each step that leads there becomes one for each way.
constexpr std::size_t kMostWaysOn = 8;

/// Chooses the locations to remove, and makes the system without them.
class Contraction {
public:
  Contraction(const System& of, const std::vector<Goal>& goals, LimitWatch& watch)
      : system(of),
        limits(watch),
        relevant(findRelevant(of, goals, watch).cells),
        events(eventsOf(of, goals)),
        values(of.cells.size()) {
    for (const auto& goal : goals) addReads(system, goal.condition, readByOthers);
    for (const auto& instance : system.instances) {
      from.emplace_back(instance.locations.size());
      isFree.emplace_back(instance.locations.size(), true);
    }
    for (TransitionId id = 0; id < system.transitions.size(); ++id) note(id);
    for (InstanceId i = 0; i < system.instances.size(); ++i) choose(i);
  }

  Contracted run() && {
    Contracted made{withoutSteps(system), {}, {}};
    for (InstanceId i = 0; i < system.instances.size(); ++i)
      if (isRemoved(i, startOf(i))) moveStart(i, made);
    Nodes nodes(made.system);
    StepCopies copies(system, made.system);
    for (TransitionId id = 0; id < system.transitions.size(); ++id) {
      limits.check();
      if (const auto* path = onlyPath(id); !path || !isRemoved(path->instance, path->location))
        add(id, nodes, copies, made.original);
    }
    return made;
  }

private:
  /// The path of a transition of one instance.
  [[nodiscard]] const Path* onlyPath(TransitionId id) const {
    const auto& parts = system.transitions[id].parts;
    return parts.size() == 1 ? &system.paths[parts.front()] : nullptr;
  }

  /// Registers a step, and what it reads of other instances.
  void note(TransitionId id) {
    limits.check();
    const Transition& transition = system.transitions[id];
    Bits read;
    addReads(system, transition.guard, read);
    read |= transition.reads;
    const bool isAlone = transition.parts.size() == 1;
    for (auto part : transition.parts) {
      const Path& path = system.paths[part];
      from[path.instance][path.location].push_back(id);
      read.erase(system.instances[path.instance].location);
      if (!isAlone || !simpleTarget(path))
        for (auto to : targetsOf(path)) isFree[path.instance][to] = false;
    }
    readByOthers |= read;
  }

  /// Where the path ends, if it has no tests, and nobody asks for the event of entering.
  [[nodiscard]] std::optional<std::uint32_t> simpleTarget(const Path& path) const {
    const auto isSimple = [](const Instruction& it) {
      return it.kind == InstructionKind::Assign || it.kind == InstructionKind::Tag ||
             it.kind == InstructionKind::Origin;
    };
    if (path.code.empty() || path.code.back().kind != InstructionKind::To) return std::nullopt;
    const auto entering = path.code.back().event;
    if ((entering != kNone && events.contains(entering)) ||
        !std::all_of(path.code.begin(), path.code.end() - 1, isSimple))
      return std::nullopt;
    return path.code.back().last;
  }

  [[nodiscard]] bool isDue(TransitionId id) const {
    const Transition& transition = system.transitions[id];
    return transition.urgent || transition.clock != kNone || transition.fails;
  }

  [[nodiscard]] bool isNeverDueAt(InstanceId instance, std::uint32_t location) const {
    return std::ranges::none_of(from[instance][location], [&](auto id) { return isDue(id); });
  }

  /// Whether the step only moves its instance, whatever the rest of the state is.
  [[nodiscard]] bool isFreeStep(TransitionId id) const {
    const Transition& transition = system.transitions[id];
    const Path* path = onlyPath(id);
    if (!path || transition.clock != kNone || transition.fails || transition.tentative ||
        path->mayFail || !simpleTarget(*path))
      return false;
    const CellId location = system.instances[path->instance].location;
    Bits read;
    addReads(system, transition.guard, read);
    read.erase(location);
    Bits written = transition.writes;
    written.erase(location);
    return read.empty() && isTrueAt(transition.guard, location, path->location) &&
           !written.meets(relevant) && !mayPass(system, transition, events);
  }

  /// Whether a condition on the location alone is true there.
  [[nodiscard]] bool isTrueAt(NodeId condition, CellId cell, std::uint32_t location) const {
    values[cell] = location;
    return evaluateUnpacked(system, condition, values).value_or(0) != 0;
  }

  /// The greatest set of locations that can be removed. The one at the start can if the instance
  /// has one way on.
  void choose(InstanceId instance) {
    auto& chosen = isFree[instance];
    const CellId cell = system.instances[instance].location;
    if (readByOthers.contains(cell)) return chosen.assign(chosen.size(), false);
    for (std::uint32_t at = 0; at < chosen.size(); ++at)
      chosen[at] = chosen[at] && !from[instance][at].empty() &&
                   std::ranges::all_of(from[instance][at], [&](auto id) { return isFreeStep(id); });
    keepWhereTimeMatters(instance);
    const auto start = startOf(instance);
    if (!chosen[start] || waysFrom(instance, start).size() == 1) return;
    chosen[start] = false;
    keepWhereTimeMatters(instance);
  }

  [[nodiscard]] std::uint32_t startOf(InstanceId instance) const {
    return static_cast<std::uint32_t>(system.cells[system.instances[instance].location].initial);
  }

  void keepWhereTimeMatters(InstanceId instance) {
    auto& chosen = isFree[instance];
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t at = 0; at < chosen.size(); ++at) {
        if (!chosen[at] || maySkip(instance, at)) continue;
        chosen[at] = false;
        changed = true;
      }
    }
  }

  /// Whether it makes no difference that the instance moves on at once: it has to, or no step is
  /// ever due where it arrives.
  [[nodiscard]] bool maySkip(InstanceId instance, std::uint32_t at) const {
    const auto ways = waysFrom(instance, at);
    return ways.size() <= kMostWaysOn &&
           (!isNeverDueAt(instance, at) || std::ranges::all_of(ways, [&](const Way& way) {
             return isNeverDueAt(instance, way.to);
           }));
  }

  [[nodiscard]] bool isRemoved(InstanceId instance, std::uint32_t location) const {
    return isFree[instance][location];
  }

  /// Steps from a removed location to one that is kept.
  struct Way {
    std::uint32_t to = 0;
    Steps steps;
  };

  /// For each location that can be reached in this way, the first way that is found.
  [[nodiscard]] std::vector<Way> waysFrom(InstanceId instance, std::uint32_t start) const {
    std::vector<TransitionId> by(from[instance].size(), kNone); // the step that leads there
    std::vector<Way> ways;
    std::vector<std::uint32_t> todo{start};
    for (std::size_t i = 0; i < todo.size(); ++i) {
      limits.check();
      if (!isRemoved(instance, todo[i])) {
        ways.push_back({todo[i], stepsTo(todo[i], start, by)});
        continue;
      }
      for (auto id : from[instance][todo[i]]) {
        const auto to = *simpleTarget(*onlyPath(id));
        if (to == start || by[to] != kNone) continue;
        by[to] = id;
        todo.push_back(to);
      }
    }
    return ways;
  }

  [[nodiscard]] Steps stepsTo(std::uint32_t at, std::uint32_t start,
                              const std::vector<TransitionId>& by) const {
    Steps steps;
    for (; at != start; at = onlyPath(by[at])->location) steps.push_back(by[at]);
    std::ranges::reverse(steps);
    return steps;
  }

  void moveStart(InstanceId instance, Contracted& made) const {
    const Way way = waysFrom(instance, startOf(instance)).front();
    made.system.cells[system.instances[instance].location].initial = way.to;
    made.before.insert(made.before.end(), way.steps.begin(), way.steps.end());
  }

  /// Adds a step, once for each way on if it leads to a removed location.
  void add(TransitionId id, Nodes& nodes, StepCopies& copies, std::vector<Steps>& original) const {
    const Path* path = onlyPath(id);
    const auto target = path ? simpleTarget(*path) : std::nullopt;
    const bool leadsOn = target && isRemoved(path->instance, *target);
    const auto ways = leadsOn ? waysFrom(path->instance, *target) : std::vector<Way>{};
    for (const auto& way : ways) {
      Path longer = *path;
      longer.code.back().last = way.to;
      longer.assignments[longer.code.back().first].value = nodes.number(way.to);
      copies.add(id, system.transitions[id], std::move(longer));
      original.push_back({id});
      original.back().insert(original.back().end(), way.steps.begin(), way.steps.end());
    }
    if (!ways.empty()) return;
    copies.add(id); // or what follows never ends, and does not matter
    original.push_back({id});
  }

  const System& system;
  LimitWatch& limits;
  Bits relevant; ///< cells
  Bits events;   ///< that the goals ask for
  Bits readByOthers;
  std::vector<std::vector<Steps>> from;     ///< by instance and location: transitions
  std::vector<std::vector<bool>> isFree;    ///< by instance and location: whether it is removed
  mutable std::vector<std::int64_t> values; ///< by cell: those with which a condition is tried
};

} // namespace

Contracted contracted(const System& system, const std::vector<Goal>& goals, LimitWatch& limits) {
  return Contraction(system, goals, limits).run();
}

} // namespace proskill::verify
