#pragma once

#include "verify/space/zone_graph.h"

namespace proskill::verify {

/// A node, wherever it is stored.
struct NodePlace {
  std::uint32_t rank = kNone; ///< kNone: nowhere
  NodeIndex node = 0;
};

/// A state and a zone that a step reached, until they become a node.
struct Candidate {
  StateId state = 0; ///< its number among the candidates
  ZoneId zone = 0;
  NodePlace from;
  TransitionId step = kNone;
};

/// The candidates for the next level of a graph: each state with each zone once, however often and
/// in whatever order they arrive.
class Candidates {
public:
  /// \param words of each state
  explicit Candidates(std::uint32_t words) : words(words), states(words) {}

  void add(const Word* state, Candidate candidate);
  /// The candidates by state, and for each state in an order that depends on nothing but the zones:
  /// a zone precedes those that it includes.
  [[nodiscard]] const std::vector<Candidate>& inOrder(const ZoneStore& zones);
  [[nodiscard]] const Word* stateOf(const Candidate& candidate) const {
    return states.at(candidate.state);
  }
  void clear() { *this = Candidates(words); }
  [[nodiscard]] std::uint64_t bytes() const {
    return states.bytes() + table.bytes() + all.capacity() * sizeof(Candidate);
  }

private:
  std::uint32_t words;
  StateStore states;
  NumberTable table;
  std::vector<Candidate> all;
};

} // namespace proskill::verify
