#pragma once

#include "viz/graph.h"

#include <vector>

namespace proskill::viz {

/// In inches, y upwards.
struct Point {
  double x = 0;
  double y = 0;
};

/// Where the nodes of a circular graph stand: clockwise in their order from the top, each start
/// outside of the node that it points to. (Graphviz's own circular layout is not the same twice.)
[[nodiscard]] std::vector<Point> placeInCircle(const Graph& graph);

} // namespace proskill::viz
