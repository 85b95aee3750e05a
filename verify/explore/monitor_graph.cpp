#include "verify/explore/monitor_graph.h"

#include <algorithm>

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

void MonitorGraph::append(Way& way, NodeIndex from, const WatchArc& arc) const {
  way.moves.push_back(arc.move);
  way.locations.push_back(nodes[from].location);
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
  bool rests = false;
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
                     .ticks = move.kind == MoveKind::Tick,
                     .location = way.locations[i],
                     .edge = move.edge};
    const auto stored = walker.becomeCalm(walk); // time may pass before each move
    mark.after = mark.until = walk.taken.size();
    rests = rests || move.kind == MoveKind::Rest;
    if (!rests) walker.moveInputs(walk, stored);
    if (mark.atStep) {
      walker.choose(walk, move.transition, move.choice);
      mark.after = mark.until = walk.taken.size() + 1;
      walker.take(walk, move.transition);
      walker.arrive(walk);
    }
    if (move.edge != kNone || mark.ticks) made.marks.push_back(mark);
  }
  made.steps = std::move(walk.taken);
  if (made.loop != made.steps.size()) return made;
  made.loop.reset(); // the run ends, and only the monitor continues
  made.rest = marksBefore;
  return made;
}

} // namespace proskill::verify
