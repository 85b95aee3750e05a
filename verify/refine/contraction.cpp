#include "verify/refine/contraction.h"

#include "verify/model/nodes.h"
#include "verify/reduce/dead_variables.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <map>
#include <optional>

namespace proskill::verify {

namespace {

/// From a removed location: each step that leads there becomes one for each way.
constexpr std::size_t kMostWaysOn = 8;

/// Chooses the locations to remove, and makes the system without them.
class Contraction {
public:
  Contraction(const System& of, const Goal& goal, LimitWatch& watch)
      : system(of), limits(watch), relevant(findRelevant(of, {goal}, watch).cells) {
    events = goal.events;
    addEvents(system, goal.condition, events);
    addReads(system, goal.condition, readByOthers);
    for (const auto& instance : system.instances) {
      from.emplace_back(instance.locations.size());
      isFree.emplace_back(instance.locations.size(), true);
    }
    for (TransitionId id = 0; id < system.transitions.size(); ++id) note(id);
    for (InstanceId i = 0; i < system.instances.size(); ++i) choose(i);
  }

  Contracted run() && {
    Contracted made{system, {}, {}};
    for (InstanceId i = 0; i < system.instances.size(); ++i)
      if (isRemoved(i, startOf(i))) moveStart(i, made);
    made.system.paths.clear();
    made.system.transitions.clear();
    Nodes nodes(made.system);
    for (TransitionId id = 0; id < system.transitions.size(); ++id) {
      limits.check();
      if (const auto* path = onlyPath(id); !path || !isRemoved(path->instance, path->location))
        add(id, nodes, made);
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
    std::vector<std::int64_t> values(system.cells.size());
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
        if (!chosen[at] || (maySkip(instance, at) && waysFrom(instance, at).size() <= kMostWaysOn))
          continue;
        chosen[at] = false;
        changed = true;
      }
    }
  }

  /// Whether it makes no difference that the instance moves on at once: it has to, or no step is
  /// ever due where it arrives.
  [[nodiscard]] bool maySkip(InstanceId instance, std::uint32_t at) const {
    return !isNeverDueAt(instance, at) ||
           std::ranges::all_of(waysFrom(instance, at),
                               [&](const auto& way) { return isNeverDueAt(instance, way.first); });
  }

  [[nodiscard]] bool isRemoved(InstanceId instance, std::uint32_t location) const {
    return isFree[instance][location];
  }

  /// The ways from a removed location to others: for each of these, the first that is found.
  [[nodiscard]] std::map<std::uint32_t, Steps> waysFrom(InstanceId instance,
                                                        std::uint32_t start) const {
    std::map<std::uint32_t, Steps> reached{{start, {}}};
    std::vector<std::uint32_t> todo{start};
    for (std::size_t i = 0; i < todo.size(); ++i) {
      limits.check();
      if (!isRemoved(instance, todo[i])) continue;
      for (auto id : from[instance][todo[i]]) {
        const auto to = *simpleTarget(*onlyPath(id));
        Steps steps = reached[todo[i]];
        steps.push_back(id);
        if (reached.try_emplace(to, std::move(steps)).second) todo.push_back(to);
      }
    }
    std::erase_if(reached, [&](const auto& it) { return isRemoved(instance, it.first); });
    return reached;
  }

  void moveStart(InstanceId instance, Contracted& made) const {
    const auto [to, steps] = *waysFrom(instance, startOf(instance)).begin();
    made.system.cells[system.instances[instance].location].initial = to;
    made.before.insert(made.before.end(), steps.begin(), steps.end());
  }

  void add(TransitionId id, Nodes& nodes, Contracted& made) {
    const Path* path = onlyPath(id);
    const auto target = path ? simpleTarget(*path) : std::nullopt;
    if (!target || !isRemoved(path->instance, *target)) return copy(id, made);
    const auto ways = waysFrom(path->instance, *target);
    if (ways.empty()) return copy(id, made); // what follows never ends and does not matter
    for (const auto& [to, steps] : ways) {
      Path longer = *path;
      longer.code.back().last = to;
      longer.assignments[longer.code.back().first].value = nodes.number(to);
      Transition transition = system.transitions[id];
      transition.parts = {static_cast<PathId>(made.system.paths.size())};
      made.system.paths.push_back(std::move(longer));
      Steps all{id};
      all.insert(all.end(), steps.begin(), steps.end());
      put(id, std::move(transition), std::move(all), made);
    }
  }

  void copy(TransitionId id, Contracted& made) {
    Transition transition = system.transitions[id];
    for (auto& part : transition.parts) {
      const auto next = static_cast<PathId>(made.system.paths.size());
      const auto [entry, isNew] = numbers.try_emplace(part, next);
      if (isNew) made.system.paths.push_back(system.paths[part]);
      part = entry->second;
    }
    put(id, std::move(transition), {id}, made);
  }

  void put(TransitionId id, Transition transition, Steps steps, Contracted& made) const {
    const auto clock = transition.clock;
    if (clock != kNone && system.clocks[clock].transition == id)
      made.system.clocks[clock].transition = static_cast<TransitionId>(made.original.size());
    made.system.transitions.push_back(std::move(transition));
    made.original.push_back(std::move(steps));
  }

  const System& system;
  LimitWatch& limits;
  Bits relevant; ///< cells
  Bits events;   ///< that the goal asks for
  Bits readByOthers;
  std::vector<std::vector<Steps>> from;  ///< by instance and location: transitions
  std::vector<std::vector<bool>> isFree; ///< by instance and location: whether it is removed
  std::map<PathId, PathId> numbers;
};

} // namespace

Contracted contracted(const System& system, const Goal& goal, LimitWatch& limits) {
  return Contraction(system, goal, limits).run();
}

} // namespace proskill::verify
