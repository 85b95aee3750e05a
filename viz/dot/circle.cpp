#include "viz/dot/circle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proskill::viz {
namespace {

constexpr double kCharacter = 0.1; ///< in inches; about the width of a character of a label
constexpr double kNodeHeight = 0.4;

class Circle {
public:
  explicit Circle(const Graph& shown) : graph(shown) {
    for (const auto& node : graph.nodes) {
      if (node.role == NodeRole::Start) continue;
      ++count;
      widest = std::max(widest, kCharacter * static_cast<double>(node.label.size()) + 0.3);
    }
  }

  std::vector<Point> place() {
    points.resize(graph.nodes.size());
    angles.resize(graph.nodes.size());
    double next = 0;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      if (graph.nodes[i].role == NodeRole::Start) continue;
      angles[i] = std::numbers::pi / 2 - 2 * std::numbers::pi * next++ / count;
      points[i] = at(angles[i], 0, 0);
    }
    for (const auto& edge : graph.edges)
      if (graph.nodes[edge.from].role == NodeRole::Start)
        points[edge.from] = at(angles[edge.to], widest / 2 + 0.5, kNodeHeight / 2 + 0.45);
    return std::move(points);
  }

private:
  /// A point on the ellipse, or outside by `right` and `up`. Wide labels make the ellipse wide,
  /// many nodes make it high.
  [[nodiscard]] Point at(double angle, double right, double up) const {
    const double x = std::max(0.55 * widest, 0.27 * count * widest * 0.75) + 0.2;
    const double y = 0.28 * count + 0.2;
    return {(x + right) * std::cos(angle), (y + up) * std::sin(angle)};
  }

  const Graph& graph;
  double count = 0;
  double widest = 0;
  std::vector<Point> points;
  std::vector<double> angles;
};

} // namespace

std::vector<Point> placeInCircle(const Graph& graph) { return Circle(graph).place(); }

} // namespace proskill::viz
