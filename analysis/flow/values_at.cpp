#include "analysis/flow/values_at.h"

#include <algorithm>

namespace proskill::analysis::flow {

namespace {

bool contains(syntax::Range outer, syntax::Range inner) {
  return outer.begin <= inner.begin && inner.end <= outer.end;
}

/// Calls `visit(point, node)` for each reached step of each process.
template <class Visit> void forEachPoint(const Flow& flow, FileId file, Visit&& visit) {
  for (ProcessId id = 0; id < flow.system.size(); ++id) {
    const Process& process = flow.system[id];
    if (!process.graph || !process.analysed) continue;
    if (flow.system.at(process, {}).file != file) continue;
    for (NodeId node = 0; node < process.graph->nodes.size(); ++node)
      visit(Point{id, node, {file, (*process.graph)[node].range}}, (*process.graph)[node]);
  }
}

/// The ranges of a step's text. A start has two: its preconditions and its effects.
template <class Visit> void forEachText(const Node& node, Visit&& visit) {
  visit(node.range);
  for (const auto* condition : node.conditions) visit(condition->range);
  if (node.effects && !node.effects->range.empty()) visit(node.effects->range);
}

} // namespace

std::vector<Point> pointsAround(const Flow& flow, Location place) {
  std::vector<Point> found;
  auto offer = [&](const Point& point) {
    if (!contains(point.at.range, place.range)) return;
    if (!found.empty()) {
      const auto best = found.front().at.range.length();
      if (point.at.range.length() > best) return;
      if (point.at.range.length() < best) found.clear();
    }
    found.push_back(point);
  };
  forEachPoint(flow, place.file, [&](Point point, const Node& node) {
    // the step happens after the guard has failed, but the guard is tested all the time
    if (node.invariant && contains(node.invariant->guard.range, place.range)) return;
    forEachText(node, [&](syntax::Range text) {
      point.at.range = text;
      offer(point);
    });
  });
  return found;
}

std::vector<Point> pointsTouching(const Flow& flow, Location range) {
  std::vector<Point> found;
  forEachPoint(flow, range.file, [&](const Point& point, const Node& node) {
    bool isIn = false;
    forEachText(node, [&](syntax::Range text) { isIn |= text.touches(range.range); });
    if (isIn) found.push_back(point);
  });
  return found;
}

std::optional<ValueSet> valuesAt(const Flow& flow, const std::vector<Point>& points,
                                 VariableId variable) {
  std::optional<ValueSet> values;
  for (const Point& point : points) {
    const auto slot = flow.system[point.process].slots.find(variable);
    const State state = flow.solver.before(point.process, point.node);
    if (!slot || !state.reachable) continue;
    values = values.value_or(ValueSet()) | state.values[*slot];
  }
  return values;
}

bool isReached(const Flow& flow, const std::vector<Point>& points) {
  return std::ranges::any_of(
      points, [&](const Point& point) { return flow.solver.reachable(point.process, point.node); });
}

} // namespace proskill::analysis::flow
