#pragma once

#include <cstddef>
#include <string>

/// How the parts of a picture are called in DOT, and so the groups of its SVG.
namespace proskill::viz {

[[nodiscard]] inline std::string nodeId(std::size_t index) { return "n" + std::to_string(index); }
[[nodiscard]] inline std::string edgeId(std::size_t index) { return "e" + std::to_string(index); }
/// Graphviz draws a frame around what is called so.
[[nodiscard]] inline std::string clusterId(std::size_t index) {
  return "cluster_" + std::to_string(index);
}

} // namespace proskill::viz
