#pragma once

#include "verify/run.h"
#include "verify/timing.h"
#include "verify/transition_set.h"

namespace proskill::verify {

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
  void evaluate(std::size_t k, Word candidates, const Word* state, TransitionSet& enabled) const;
  [[nodiscard]] std::size_t locationOf(InstanceId instance, const Word* state) const;

  const System& system;
  TransitionSet urgent;
  TransitionSet clocked;
  std::vector<TransitionSet> affected; ///< by transition
  /// By instance and location: transitions that are not excluded by the instance being there.
  std::vector<std::vector<TransitionSet>> possible;
};

} // namespace proskill::verify
