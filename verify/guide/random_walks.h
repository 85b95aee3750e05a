#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace proskill::verify {

/// The order of a search by random walks: from each node to one of its new successors, until there
/// is none or the walk is long; then from any node that is left. So the search soon gets to the end
/// of a mission, whatever runs beside it. The order is the same each time.
class RandomWalks {
public:
  using Node = std::uint32_t;

  /// Adds a new successor of the node that was taken last, or the initial node.
  void add(Node node) { next.push_back(node); }
  /// \pre some nodes are left
  Node take();

private:
  Node takeFrom(std::vector<Node>& nodes);

  std::minstd_rand random;
  std::vector<Node> next; ///< successors of the node that was taken last
  std::vector<Node> left; ///< of the nodes before
  std::size_t length = 0; ///< of the current walk
};

} // namespace proskill::verify
