#pragma once

#include "verify/graph/recent_results.h"
#include "verify/model/number_table.h"

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace proskill::verify {

using SetId = std::uint32_t;

/// Sets of numbers, each stored once, so that equal sets have equal ids. A set is a tree over the
/// bits of its numbers, and sets that differ little share most of their nodes.
/// Okasaki, Gill, "Fast mergeable integer maps", ML Workshop 1998.
class NumberSets {
public:
  static constexpr SetId kEmpty = 0;

  NumberSets();

  [[nodiscard]] SetId single(std::uint32_t number);
  [[nodiscard]] SetId unite(SetId a, SetId b);
  /// The numbers of `a` that are not in `b`.
  [[nodiscard]] SetId without(SetId a, SetId b);
  [[nodiscard]] std::uint32_t sizeOf(SetId set) const { return nodes[set].size; }
  /// Visits the numbers, ascending. New sets may be made meanwhile.
  template <class Visit> void eachIn(SetId set, const Visit& visit) const {
    if (set == kEmpty) return;
    if (isLeaf(set)) return eachInLeaf(set, visit);
    eachIn(nodes[set].left, visit);
    eachIn(nodes[set].right, visit);
  }

  /// A set that is not empty is a leaf, with numbers close to each other, or the union of two other
  /// sets.
  [[nodiscard]] bool isLeaf(SetId set) const { return lowestBit(nodes[set].key) == 1; }
  [[nodiscard]] std::pair<SetId, SetId> partsOf(SetId set) const {
    return {nodes[set].left, nodes[set].right};
  }

  /// The ids that were given are below this.
  [[nodiscard]] SetId end() const { return static_cast<SetId>(nodes.size()); }
  /// Whether so many sets were made that it is time for removeUnused().
  [[nodiscard]] bool isCrowded() const { return nodes.size() > most; }
  /// Removes all sets that are neither needed nor part of one. Ids change.
  /// \param needed by id
  /// \return the new ids of the sets that remain, by their old ones
  std::vector<SetId> removeUnused(std::vector<bool> needed);

  [[nodiscard]] std::uint64_t bytes() const {
    return nodes.capacity() * sizeof(Node) + table.bytes() + recent.bytes();
  }
  /// Bytes that the next few sets, or removeUnused(), may allocate at once.
  [[nodiscard]] std::uint64_t growth() const {
    const bool isNearlyCrowded = nodes.size() + kBetweenGrowthChecks > most;
    return growthOf(nodes) + table.growth() + recent.growth(nodes.size()) +
           (isNearlyCrowded ? nodes.size() * (sizeof(Node) + sizeof(SetId)) : 0);
  }

private:
  /// The lowest set bit of a key is the one by which a node branches; the bits above it are the
  /// same in all numbers of the set. A leaf has 64 numbers, as a mask in `left` and `right`, and
  /// its key is odd.
  struct Node {
    std::uint32_t key = 0;
    std::uint32_t left = 0;
    std::uint32_t right = 0;
    std::uint32_t size = 0;
    friend bool operator==(const Node&, const Node&) = default;
  };
  enum Operation : std::uint32_t { kUnite, kWithout };

  [[nodiscard]] static std::uint32_t lowestBit(std::uint32_t key) { return key & (~key + 1); }
  [[nodiscard]] static bool isWithin(std::uint32_t key, std::uint32_t outer) {
    const std::uint32_t bit = lowestBit(outer);
    return lowestBit(key) < bit && ((key ^ outer) & ~(2 * bit - 1)) == 0;
  }
  [[nodiscard]] static bool isRight(std::uint32_t key, std::uint32_t outer) {
    return (key & lowestBit(outer)) != 0;
  }
  [[nodiscard]] std::uint64_t maskOf(SetId leaf) const {
    return std::uint64_t{nodes[leaf].right} << 32 | nodes[leaf].left;
  }
  template <class Visit> void eachInLeaf(SetId leaf, const Visit& visit) const {
    const std::uint32_t first = nodes[leaf].key / 2 * 64;
    for (std::uint64_t rest = maskOf(leaf); rest != 0; rest &= rest - 1)
      visit(first + static_cast<std::uint32_t>(std::countr_zero(rest)));
  }
  [[nodiscard]] SetId add(const Node& node);
  [[nodiscard]] SetId leaf(std::uint32_t key, std::uint64_t mask);
  [[nodiscard]] SetId branch(std::uint32_t key, SetId left, SetId right);
  [[nodiscard]] SetId join(SetId a, SetId b);
  [[nodiscard]] SetId computeUnion(SetId a, SetId b);
  [[nodiscard]] SetId computeDifference(SetId a, SetId b);

  LargeVector<Node> nodes;
  NumberTable table;
  std::size_t most; ///< nodes until unused ones are removed
  RecentResults<SetId> recent;
};

} // namespace proskill::verify
