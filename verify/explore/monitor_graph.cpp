#include "verify/explore/monitor_graph.h"

#include "graph/components.h"

#include <algorithm>
#include <deque>

namespace proskill::verify {

std::uint64_t MonitorGraph::bytes() const {
  return nodes.capacity() * sizeof(WatchNode) + arcs.capacity() * sizeof(std::vector<WatchArc>) +
         arcCount * sizeof(WatchArc);
}

void MonitorGraph::addNode(const WatchNode& node) {
  nodes.push_back(node);
  if (cycles) arcs.emplace_back();
}

void MonitorGraph::addArc(NodeIndex from, NodeIndex to, WatchMove move) {
  if (!cycles) return;
  arcs[from].push_back({to, move});
  ++arcCount;
}

Evidence MonitorGraph::evidenceTo(NodeIndex node) const {
  return evidenceOf(wayTo(node), std::nullopt);
}

std::optional<Evidence> MonitorGraph::evidenceOfCycle() const {
  const auto component = graph::componentsOf(nodes.size(), [&](NodeIndex node, std::size_t i) {
    return i < arcs[node].size() ? arcs[node][i].target : graph::kNoNode;
  });
  std::vector<NodeIndex> size(nodes.size());
  for (auto id : component) ++size[id];
  for (NodeIndex node = 0; node < nodes.size(); ++node) {
    const bool goesRound =
        size[component[node]] > 1 || std::ranges::count(arcs[node], node, &WatchArc::target) > 0;
    if (!goesRound || !monitor.locations[nodes[node].location].accepting) continue;
    const auto loop = cycleThrough(node, component);
    if (!loop) continue;
    Way way = wayTo(node);
    const std::size_t stem = way.moves.size();
    way.moves.insert(way.moves.end(), loop->moves.begin(), loop->moves.end());
    way.locations.insert(way.locations.end(), loop->locations.begin(), loop->locations.end());
    return evidenceOf(way, stem);
  }
  return std::nullopt;
}

/// The shortest way from a node to itself, breadth first within its component.
std::optional<MonitorGraph::Way>
MonitorGraph::cycleThrough(NodeIndex node, const std::vector<NodeIndex>& component) const {
  std::vector<std::pair<NodeIndex, std::size_t>> from(nodes.size(), {kNone, 0});
  std::deque<NodeIndex> todo{node};
  while (!todo.empty()) {
    const NodeIndex at = todo.front();
    todo.pop_front();
    for (std::size_t i = 0; i < arcs[at].size(); ++i) {
      const NodeIndex target = arcs[at][i].target;
      if (component[target] != component[node] || from[target].first != kNone) continue;
      from[target] = {at, i};
      if (target != node) {
        todo.push_back(target);
        continue;
      }
      Way way;
      for (NodeIndex back = node; way.moves.empty() || back != node; back = from[back].first) {
        way.moves.push_back(arcs[from[back].first][from[back].second].move);
        way.locations.push_back(nodes[from[back].first].location);
      }
      std::ranges::reverse(way.moves);
      std::ranges::reverse(way.locations);
      return way;
    }
  }
  return std::nullopt;
}

MonitorGraph::Way MonitorGraph::wayTo(NodeIndex index) const {
  Way way;
  for (; nodes[index].parent != kNone; index = nodes[index].parent) {
    way.moves.push_back(nodes[index].move);
    way.locations.push_back(nodes[nodes[index].parent].location);
  }
  std::ranges::reverse(way.moves);
  std::ranges::reverse(way.locations);
  return way;
}

Evidence MonitorGraph::evidenceOf(const Way& way, std::optional<std::size_t> loop) const {
  Evidence made;
  made.monitor = &monitor;
  std::size_t marksBefore = 0;
  Walk walk = walker.fromStart();
  walker.arrive(walk);
  for (std::size_t i = 0; i < way.moves.size(); ++i) {
    const WatchMove& move = way.moves[i];
    if (loop == i) {
      made.loop = walk.taken.size();
      marksBefore = made.marks.size();
    }
    MonitorMove mark{.atStep = move.kind == MoveKind::Step,
                     .atEnd = move.kind == MoveKind::Stutter,
                     .location = way.locations[i],
                     .edge = move.edge};
    const auto stored = walker.becomeCalm(walk); // time may pass before each move
    mark.after = mark.until = walk.taken.size();
    walker.moveInputs(walk, stored);
    if (mark.atStep) {
      walker.choose(walk, move.transition, move.choice);
      mark.after = mark.until = walk.taken.size() + 1;
      walker.take(walk, move.transition);
      walker.arrive(walk);
    }
    if (move.edge != kNone) made.marks.push_back(mark);
  }
  made.steps = std::move(walk.taken);
  if (made.loop != made.steps.size()) return made;
  made.loop.reset(); // the run ends; only the monitor goes on
  made.rest = marksBefore;
  return made;
}

} // namespace proskill::verify
