#pragma once

#include "verify/memory/large_vector.h"

#include <bit>
#include <cstdint>

namespace proskill::verify {

/// The nodes from which a search first reached each node, in two bits a node. Nodes are numbered as
/// they are found, so the children of an expanded node follow those of the one expanded before. A
/// bit string has a 1 for each expansion, followed by a 0 for each child.
class Parents {
public:
  /// Call this for each node that is expanded, before its children are added.
  void expand(std::uint32_t node);
  /// The next node is a child of the one that was expanded last, or the root.
  void addChild();
  /// The parent of a node; UINT32_MAX for the root.
  [[nodiscard]] std::uint32_t of(std::uint32_t child) const;
  [[nodiscard]] std::uint64_t bytes() const {
    return (bits.capacity() + zerosBefore.capacity()) * sizeof(std::uint64_t) +
           order.capacity() * sizeof(std::uint32_t);
  }

private:
  static constexpr std::size_t kWordsOfBlock = 8;

  void append(bool bit);

  LargeVector<std::uint64_t> bits;
  std::uint64_t length = 0; ///< in bits
  std::uint64_t zeros = 0;
  std::uint64_t expansions = 0;
  LargeVector<std::uint64_t> zerosBefore; ///< by block
  /// The nodes in the order in which they were expanded, if it is not that of their numbers.
  LargeVector<std::uint32_t> order;
};

} // namespace proskill::verify
