#pragma once

#include "verify/state/transition_set.h"

#include <vector>

namespace proskill::verify {

/// Excludes transitions by the values of cells, a word of transitions at a time: each value of a
/// cell has the set of transitions that it does not exclude.
class GuardTables {
public:
  /// \param all the transitions that may be possible at all
  GuardTables(const System& system, const TransitionSet& all);

  /// Whether the tables are small enough that this is faster than to evaluate each guard.
  [[nodiscard]] bool pay() const { return !fields.empty(); }
  /// The transitions that no cell excludes. \pre pay()
  void findCandidates(const Word* state, TransitionSet& candidates) const;
  /// Those of them whose guards have other conditions, too.
  [[nodiscard]] const TransitionSet& undecided() const { return others; }

private:
  struct Field {
    std::uint32_t word = 0;
    std::uint32_t shift = 0;
    Word mask = 0;           ///< of a value
    std::uint32_t first = 0; ///< index of its first set in `sets`
  };
  class Maker;

  TransitionSet all;
  TransitionSet others;
  std::vector<Field> fields;
  std::vector<Word> sets; ///< by field, value, and word of a set
};

} // namespace proskill::verify
