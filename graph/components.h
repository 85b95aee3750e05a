#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/// Algorithms on graphs. Nodes are numbered from 0.
namespace proskill::graph {

using Node = std::uint32_t;
inline constexpr Node kNoNode = ~Node{0};

/// The i-th successor of a node; kNoNode after the last. To skip an arc, return the node itself: an
/// arc to itself has no effect.
using Successor = std::function<Node(Node node, std::size_t i)>;

/// The strongly connected components: by node, a representative of its component. Not recursive, so
/// graphs may be deep. R. Tarjan, "Depth-first search and linear graph algorithms", SIAM Journal on
/// Computing 1 (1972).
[[nodiscard]] std::vector<Node> componentsOf(std::size_t nodes, const Successor& successor);

} // namespace proskill::graph
