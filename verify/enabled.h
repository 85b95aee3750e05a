#pragma once

#include "verify/run.h"
#include "verify/timing.h"

namespace proskill::verify {

/// A set of transitions, of fixed size.
using TransitionSet = std::vector<Word>;

[[nodiscard]] inline bool contains(const TransitionSet& set, TransitionId id) {
  return (set[id / 64] >> (id % 64) & 1) != 0;
}

template <class Visit> void eachIn(const TransitionSet& set, Visit visit) {
  for (std::size_t i = 0; i < set.size(); ++i)
    for (Word rest = set[i]; rest != 0; rest &= rest - 1)
      visit(static_cast<TransitionId>(i * 64 + std::countr_zero(rest)));
}

/// Which transitions the discrete state allows. After a step, only those are looked at whose guards
/// read what the step may have written.
class Enabling {
public:
  /// Without the transitions in `dropped`.
  explicit Enabling(const System& system, const Bits& dropped = {});

  /// Of any state.
  void compute(const Word* state, TransitionSet& enabled) const;
  /// Of a state from the set of its predecessor. \param enabled of the predecessor, then of `state`
  void update(TransitionId fired, const Word* state, TransitionSet& enabled) const;
  [[nodiscard]] SignatureId signature(const TransitionSet& enabled, Timing& timing) const;
  [[nodiscard]] bool isUrgent(const TransitionSet& enabled) const;
  [[nodiscard]] const TransitionSet& urgentOnes() const { return urgent; }

private:
  void evaluate(const TransitionSet& candidates, const Word* state, TransitionSet& enabled) const;

  const System& system;
  TransitionSet urgent;
  TransitionSet clocked;
  std::vector<TransitionSet> affected; ///< by transition
  /// By instance and location: transitions that are not excluded by the instance being there.
  std::vector<std::vector<TransitionSet>> possible;
};

} // namespace proskill::verify
