#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/// Algorithms on graphs, whatever their nodes stand for. Nodes are numbered from 0.
namespace proskill::graph {

using Node = std::uint32_t;
inline constexpr Node kNoNode = ~Node{0};

/// The i-th successor of a node, kNoNode behind the last. An arc that does not count may be given
/// as one to the node itself, which is no way to anywhere.
using Successor = std::function<Node(Node node, std::size_t i)>;

/// The strongly connected components: by node, one that stands for its component. Needs no stack of
/// the machine, so that graphs may be deep. R. Tarjan, "Depth-first search and linear graph
/// algorithms", SIAM Journal on Computing 1 (1972).
[[nodiscard]] std::vector<Node> componentsOf(std::size_t nodes, const Successor& successor);

} // namespace proskill::graph
