#pragma once

#include <cstddef>
#include <string>

/// Names of a picture's parts in DOT, and so the ids of SVG groups.
namespace proskill::viz {

[[nodiscard]] inline std::string nodeId(std::size_t index) { return "n" + std::to_string(index); }
[[nodiscard]] inline std::string edgeId(std::size_t index) { return "e" + std::to_string(index); }
/// Graphviz draws a frame around subgraphs with such names.
[[nodiscard]] inline std::string clusterId(std::size_t index) {
  return "cluster_" + std::to_string(index);
}

} // namespace proskill::viz
