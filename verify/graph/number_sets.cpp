#include "verify/graph/number_sets.h"

#include <utility>

namespace proskill::verify {

namespace {

constexpr std::size_t kFewNodes = 1U << 16;

} // namespace

NumberSets::NumberSets() : nodes(1), most(kFewNodes) {}

SetId NumberSets::add(const Node& node) {
  const std::uint64_t hash = mix(mix(0, std::uint64_t{node.left} << 32 | node.right), node.key);
  const auto next = end();
  const auto id = table.findOrAdd(mix(hash, hash >> 32), next,
                                  [&](SetId other) { return nodes[other] == node; });
  if (id == next) {
    nodes.push_back(node);
    recent.fit(nodes.size());
  }
  return id;
}

SetId NumberSets::leaf(std::uint32_t key, std::uint64_t mask) {
  if (mask == 0) return kEmpty;
  return add({key, static_cast<std::uint32_t>(mask), static_cast<std::uint32_t>(mask >> 32),
              static_cast<std::uint32_t>(std::popcount(mask))});
}

/// The union of two sets that a key divides.
SetId NumberSets::branch(std::uint32_t key, SetId left, SetId right) {
  if (left == kEmpty) return right;
  if (right == kEmpty) return left;
  return add({key, left, right, nodes[left].size + nodes[right].size});
}

SetId NumberSets::single(std::uint32_t number) {
  return leaf(number / 64 * 2 + 1, std::uint64_t{1} << number % 64);
}

SetId NumberSets::unite(SetId a, SetId b) {
  if (a == b || b == kEmpty) return a;
  if (a == kEmpty) return b;
  if (a > b) std::swap(a, b);
  if (const SetId* known = recent.find({a, b, kUnite, 0})) return *known;
  const SetId made = computeUnion(a, b);
  recent.put({a, b, kUnite, 0}, made);
  return made;
}

SetId NumberSets::computeUnion(SetId a, SetId b) {
  if (isWithin(nodes[a].key, nodes[b].key)) std::swap(a, b);
  const Node one = nodes[a];
  const Node other = nodes[b];
  if (one.key == other.key) {
    if (isLeaf(a)) return leaf(one.key, maskOf(a) | maskOf(b));
    const SetId left = unite(one.left, other.left);
    return branch(one.key, left, unite(one.right, other.right));
  }
  if (!isWithin(other.key, one.key)) return join(a, b);
  if (isRight(other.key, one.key)) return branch(one.key, one.left, unite(one.right, b));
  return branch(one.key, unite(one.left, b), one.right);
}

/// The union of two sets whose keys differ above the bits by which they branch.
SetId NumberSets::join(SetId a, SetId b) {
  const std::uint32_t bit = std::bit_floor(nodes[a].key ^ nodes[b].key);
  if ((nodes[a].key & bit) != 0) std::swap(a, b);
  return branch((nodes[a].key & ~(2 * bit - 1)) | bit, a, b);
}

SetId NumberSets::without(SetId a, SetId b) {
  if (a == b || a == kEmpty) return kEmpty;
  if (b == kEmpty) return a;
  if (const SetId* known = recent.find({a, b, kWithout, 0})) return *known;
  const SetId made = computeDifference(a, b);
  recent.put({a, b, kWithout, 0}, made);
  return made;
}

SetId NumberSets::computeDifference(SetId a, SetId b) {
  const Node one = nodes[a];
  const Node other = nodes[b];
  if (one.key == other.key) {
    if (isLeaf(a)) return leaf(one.key, maskOf(a) & ~maskOf(b));
    const SetId left = without(one.left, other.left);
    return branch(one.key, left, without(one.right, other.right));
  }
  if (isWithin(one.key, other.key))
    return without(a, isRight(one.key, other.key) ? other.right : other.left);
  if (!isWithin(other.key, one.key)) return a;
  if (isRight(other.key, one.key)) return branch(one.key, one.left, without(one.right, b));
  return branch(one.key, without(one.left, b), one.right);
}

std::vector<SetId> NumberSets::removeUnused(std::vector<bool> needed) {
  for (SetId i = end(); --i > 0;) {
    if (!needed[i] || isLeaf(i)) continue;
    needed[nodes[i].left] = true; // a part is older than the whole
    needed[nodes[i].right] = true;
  }
  std::vector<SetId> moved(nodes.size());
  const auto before = std::exchange(nodes, LargeVector<Node>(1));
  table = {};
  recent.clear();
  for (SetId i = 1; i < before.size(); ++i) {
    if (!needed[i]) continue;
    Node node = before[i];
    if (lowestBit(node.key) != 1) {
      node.left = moved[node.left];
      node.right = moved[node.right];
    }
    moved[i] = add(node);
  }
  most = std::max(kFewNodes, 2 * nodes.size());
  return moved;
}

} // namespace proskill::verify
