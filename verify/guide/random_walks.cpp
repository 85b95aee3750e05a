#include "verify/guide/random_walks.h"

#include <optional>
#include <utility>

namespace proskill::verify {

namespace {

constexpr std::size_t kLongestWalk =
    300; ///< nodes of a walk; the missions of bench/ take 30 to 200

} // namespace

RandomWalks::Node RandomWalks::take() {
  std::optional<Node> successor;
  if (!next.empty() && length++ < kLongestWalk) successor = takeFrom(next);
  left.insert(left.end(), next.begin(), next.end());
  next.clear();
  if (successor) return *successor;
  length = 0;
  return takeFrom(left);
}

/// Removes any of them.
RandomWalks::Node RandomWalks::takeFrom(std::vector<Node>& nodes) {
  std::swap(nodes[random() % nodes.size()], nodes.back());
  const Node taken = nodes.back();
  nodes.pop_back();
  return taken;
}

} // namespace proskill::verify
