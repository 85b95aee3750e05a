#pragma once

#include "viz/graph.h"

#include <vector>

namespace proskill::viz {

/// In inches; y points up.
struct Point {
  double x = 0;
  double y = 0;
};

/// Positions of nodes in a circular graph: clockwise from the top in their order; each start node
/// is outside of the node to which it points. (Graphviz's own circular layout is not
/// deterministic.)
[[nodiscard]] std::vector<Point> placeInCircle(const Graph& graph);

} // namespace proskill::viz
