#pragma once

#include "verify/spill/state_code.h"

namespace proskill::verify {

/// What the files of a search contain.
struct SpillFormat {
  std::uint32_t words = 0;     ///< of each state
  bool hasZones = false;       ///< otherwise all zones are those without clocks
  bool hasDiscoveries = false; ///< how nodes were reached
  bool inclusion = false;      ///< a zone covers those that it includes
};

/// How a node was reached.
struct Discovery {
  std::uint64_t parent = 0; ///< 1 + the number of the node; 0: it has none
  std::uint64_t order = 0;  ///< nodes that were reached earlier have smaller numbers
  TransitionId step = kNone;
};

/// A state with some zones, all of which have the same dimension, and how each was reached.
struct StateGroup {
  std::vector<Word> state;
  std::uint32_t dimension = 1;
  std::vector<Bound> bounds; ///< matrix by matrix
  std::vector<Discovery> discoveries;

  [[nodiscard]] std::size_t size() const {
    return bounds.size() / (std::size_t{dimension} * dimension);
  }
  [[nodiscard]] std::span<const Bound> zone(std::size_t i) const {
    const std::size_t entries = std::size_t{dimension} * dimension;
    return {bounds.data() + i * entries, entries};
  }
  void clear() {
    bounds.clear();
    discoveries.clear();
  }
};

} // namespace proskill::verify
