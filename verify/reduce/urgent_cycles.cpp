#include "verify/reduce/urgent_cycles.h"

#include "verify/model/conjuncts.h"
#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace proskill::verify {

namespace {

constexpr int kMostConditions = 6; ///< by which paths are divided

/// The locations to which the paths lead from each location, by any number of them.
std::vector<Bits> reachedBy(const System& system, const std::vector<PathId>& paths,
                            LimitWatch& limits) {
  std::vector<Bits> reached(
      system.instances[system.paths[paths.front()].instance].locations.size());
  for (bool grew = true; grew;) {
    grew = false;
    for (auto id : paths) {
      limits.check();
      Bits& here = reached[system.paths[id].location];
      const auto before = here.count();
      for (auto target : targetsOf(system.paths[id])) {
        here.insert(target);
        here |= Bits(reached[target]);
      }
      grew = grew || here.count() != before;
    }
  }
  return reached;
}

/// Those of the paths that are on a cycle of them.
std::vector<PathId> onCycles(const System& system, std::vector<PathId> paths, LimitWatch& limits) {
  if (paths.empty()) return paths;
  const auto reached = reachedBy(system, paths, limits);
  std::erase_if(paths, [&](PathId id) {
    const auto from = system.paths[id].location;
    return std::ranges::none_of(targetsOf(system.paths[id]), [&](std::uint32_t target) {
      return target == from || reached[target].contains(from);
    });
  });
  return paths;
}

bool areOpposite(const System& system, NodeId a, NodeId b) {
  const auto isNegation = [&](NodeId of, NodeId node) {
    return system.nodes[of].op == NodeOp::Not && system.nodes[of].a == node;
  };
  return isNegation(a, b) || isNegation(b, a);
}

/// Divides the paths of an instance by conditions that do not change.
class Division {
public:
  Division(const System& of, const Bits& cells, LimitWatch& watch)
      : system(of), changing(cells), limits(watch) {}

  [[nodiscard]] bool mayRepeat(std::vector<PathId> paths, int most) {
    paths = onCycles(system, std::move(paths), limits);
    if (paths.empty()) return false;
    const auto opposite = most > 0 ? oppositeIn(paths) : std::nullopt;
    if (!opposite) return true;
    return mayRepeat(without(opposite->first, paths), most - 1) ||
           mayRepeat(without(opposite->second, paths), most - 1);
  }

private:
  /// A condition of a path and its negation, of another one.
  [[nodiscard]] std::optional<std::pair<NodeId, NodeId>>
  oppositeIn(const std::vector<PathId>& paths) {
    std::vector<NodeId> all;
    for (auto id : paths) all.insert(all.end(), fixedOf(id).begin(), fixedOf(id).end());
    for (auto a : all)
      for (auto b : all)
        if (areOpposite(system, a, b)) return std::pair{a, b};
    return std::nullopt;
  }

  [[nodiscard]] std::vector<PathId> without(NodeId condition, std::vector<PathId> paths) {
    std::erase_if(paths, [&](PathId id) { return std::ranges::count(fixedOf(id), condition) > 0; });
    return paths;
  }

  /// The conditions of a path that read nothing that may change.
  [[nodiscard]] const std::vector<NodeId>& fixedOf(PathId id) {
    const auto [entry, isNew] = fixed.try_emplace(id);
    if (!isNew) return entry->second;
    limits.check();
    for (auto node : conjunctsOf(system, system.paths[id].guard)) {
      Bits read;
      addReads(system, node, read);
      if (!read.meets(changing)) entry->second.push_back(node);
    }
    return entry->second;
  }

  const System& system;
  const Bits& changing;
  LimitWatch& limits;
  std::map<PathId, std::vector<NodeId>> fixed; ///< by path
};

} // namespace

bool hasCycle(const System& system, std::vector<PathId> paths, LimitWatch& limits) {
  return !onCycles(system, std::move(paths), limits).empty();
}

bool mayRepeatAlone(const System& system, std::vector<PathId> paths, const Bits& changing,
                    LimitWatch& limits) {
  return Division(system, changing, limits).mayRepeat(std::move(paths), kMostConditions);
}

} // namespace proskill::verify
