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
  /// Looks again at `changed`, after something that their guards read was written.
  void refresh(const TransitionSet& changed, const Word* state, TransitionSet& enabled) const;
  /// Calls `visit` with each transition whose instances are where it needs them.
  template <class Visit> void eachHere(const Word* state, Visit visit) const {
    for (std::size_t k = 0; k < urgent.size(); ++k) visitWord(k, here(k, state), visit);
  }
  /// The same for urgent ones.
  template <class Visit> void eachUrgentHere(const Word* state, Visit visit) const {
    for (std::size_t k = 0; k < urgent.size(); ++k)
      if (urgent[k] != 0) visitWord(k, here(k, state) & urgent[k], visit);
  }
  [[nodiscard]] SignatureId signature(const TransitionSet& enabled, Timing& timing) const {
    return signature(enabled, isUrgent(enabled), timing);
  }
  [[nodiscard]] SignatureId signature(const TransitionSet& enabled, bool isUrgent,
                                      Timing& timing) const;
  [[nodiscard]] bool isUrgent(const TransitionSet& enabled) const;
  /// Whether another enabled transition has priority over it.
  [[nodiscard]] bool isBlocked(TransitionId transition, const TransitionSet& enabled) const {
    for (auto blocker : system.transitions[transition].blockers)
      if (contains(enabled, blocker)) return true;
    return false;
  }
  [[nodiscard]] const TransitionSet& urgentOnes() const { return urgent; }

private:
  template <class Visit> static void visitWord(std::size_t k, Word set, Visit& visit) {
    for (; set != 0; set &= set - 1)
      visit(static_cast<TransitionId>(k * 64 + static_cast<std::size_t>(std::countr_zero(set))));
  }
  [[nodiscard]] Word here(std::size_t k, const Word* state) const;
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
