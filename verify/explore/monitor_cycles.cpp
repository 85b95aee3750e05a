#include "verify/explore/monitor_graph.h"

#include "graph/components.h"

#include <algorithm>
#include <deque>

namespace proskill::verify {

/// Finds a component whose nodes and arcs meet all needs, and a cycle in it that does. The first
/// need is an accepting location; the second is that the monitor reads something. For fair runs,
/// the end of each open wait follows, and finally a tick.
class MonitorGraph::CycleSearch {
public:
  CycleSearch(const MonitorGraph& of, const System& in, const FairNeeds& with)
      : graph(of),
        system(in),
        needs(with),
        component(graph::componentsOf(of.nodes.size(), [&](NodeIndex node, std::size_t i) {
          return i < of.arcs[node].size() ? of.arcs[node][i].target : graph::kNoNode;
        })) {}

  std::optional<Evidence> find() {
    std::vector<Needs> met(graph.nodes.size()); // by component
    for (NodeIndex node = 0; node < graph.nodes.size(); ++node)
      for (const WatchArc& arc : graph.arcs[node])
        if (isInside(node, arc)) add(met[component[node]], node, arc);
    const Needs all(needCount(), true);
    for (NodeIndex node = 0; node < graph.nodes.size(); ++node)
      for (const WatchArc& arc : graph.arcs[node])
        if (isInside(node, arc) && met[component[node]] == all && isLast(node, arc))
          return evidence(node, arc);
    return std::nullopt;
  }

private:
  using Needs = std::vector<bool>;

  static constexpr std::size_t kAccepting = 0;
  static constexpr std::size_t kRead = 1;
  static constexpr std::size_t kWaits = 2;

  [[nodiscard]] std::size_t needCount() const {
    return kWaits + needs.waits.size() + (needs.ticks ? 1 : 0);
  }

  [[nodiscard]] bool isInside(NodeIndex node, const WatchArc& arc) const {
    return component[arc.target] == component[node];
  }

  /// Adds what an arc meets together with its source.
  void add(Needs& met, NodeIndex node, const WatchArc& arc) const {
    met.resize(needCount());
    for (std::size_t need = 0; need < met.size(); ++need)
      met[need] = met[need] || meets(node, arc, need);
  }

  [[nodiscard]] bool meets(NodeIndex node, const WatchArc& arc, std::size_t need) const {
    if (need == kAccepting) return graph.monitor.locations[graph.nodes[node].location].accepting;
    if (need == kRead) return arc.move.kind == MoveKind::Step || arc.move.kind == MoveKind::Stutter;
    const std::size_t wait = need - kWaits;
    if (wait == needs.waits.size()) return arc.move.kind == MoveKind::Tick;
    return !needs.isWaiting(node, wait) ||
           (arc.move.kind == MoveKind::Step &&
            system.transitions[arc.move.transition].consumed.contains(needs.waits[wait].instance));
  }

  /// Whether the arc may close the cycle: time passes in each round.
  [[nodiscard]] bool isLast(NodeIndex node, const WatchArc& arc) const {
    return needs.ticks ? arc.move.kind == MoveKind::Tick : meets(node, arc, kAccepting);
  }

  /// A run to the node and once around the cycle. For fair runs, the arc is a tick that leads into
  /// the cycle and closes it.
  [[nodiscard]] Evidence evidence(NodeIndex node, const WatchArc& last) const {
    const auto leadsBack = [&](NodeIndex, const WatchArc& arc) { return arc.target == node; };
    Needs met;
    Way way = graph.wayTo(node);
    if (!needs.ticks) {
      const std::size_t stem = way.moves.size();
      extend(way, node, met, leadsBack);
      return graph.evidenceOf(way, stem);
    }
    graph.append(way, node, last);
    const std::size_t stem = way.moves.size();
    add(met, node, last);
    NodeIndex at = last.target;
    while (std::ranges::find(met, false) != met.end())
      at = extend(way, at, met, [&](NodeIndex from, const WatchArc& arc) {
        for (std::size_t need = 0; need < met.size(); ++need)
          if (!met[need] && meets(from, arc, need)) return true;
        return false;
      });
    if (at != node) extend(way, at, met, leadsBack);
    graph.append(way, node, last);
    return graph.evidenceOf(way, stem);
  }

  /// The shortest path within the component whose last arc is wanted. \return its end
  template <class Wanted>
  NodeIndex extend(Way& way, NodeIndex from, Needs& met, Wanted wanted) const {
    std::vector<std::pair<NodeIndex, std::size_t>> cameBy(graph.nodes.size(), {kNone, 0});
    std::deque<NodeIndex> todo{from};
    while (!todo.empty()) {
      const NodeIndex at = todo.front();
      todo.pop_front();
      for (std::size_t i = 0; i < graph.arcs[at].size(); ++i) {
        const WatchArc& arc = graph.arcs[at][i];
        if (!isInside(at, arc)) continue;
        if (wanted(at, arc)) return walk(way, from, cameBy, {at, i}, met);
        if (arc.target == from || cameBy[arc.target].first != kNone) continue;
        cameBy[arc.target] = {at, i};
        todo.push_back(arc.target);
      }
    }
    return from; // not in a component
  }

  NodeIndex walk(Way& way, NodeIndex from,
                 const std::vector<std::pair<NodeIndex, std::size_t>>& cameBy,
                 std::pair<NodeIndex, std::size_t> last, Needs& met) const {
    std::vector<std::pair<NodeIndex, std::size_t>> taken{last};
    while (taken.back().first != from) taken.push_back(cameBy[taken.back().first]);
    for (std::size_t i = taken.size(); i-- > 0;) {
      const auto& [node, arc] = taken[i];
      graph.append(way, node, graph.arcs[node][arc]);
      add(met, node, graph.arcs[node][arc]);
    }
    return graph.arcs[last.first][last.second].target;
  }

  const MonitorGraph& graph;
  const System& system;
  const FairNeeds& needs;
  std::vector<NodeIndex> component;
};

std::optional<Evidence> MonitorGraph::evidenceOfCycle(const System& system,
                                                      const FairNeeds& needs) const {
  return CycleSearch(*this, system, needs).find();
}

} // namespace proskill::verify
