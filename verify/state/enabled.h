#pragma once

#include "verify/state/run.h"
#include "verify/state/timing.h"
#include "verify/state/transition_set.h"

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
  /// Transitions of one word of a set.
  struct Slice {
    std::uint32_t word = 0;
    Word bits = 0;
  };

  void findPlaces(const Bits& dropped);
  void findAffected(const Bits& dropped);
  void look(TransitionId transition, const Word* state, TransitionSet& enabled) const;
  [[nodiscard]] std::size_t locationOf(InstanceId instance, const Word* state) const;

  const System& system;
  TransitionSet urgent;
  TransitionSet clocked;
  /// By transition: those whose guards read what it writes, other than where their own instances
  /// are.
  std::vector<std::vector<Slice>> affected;
  using ByPlace = std::vector<std::vector<std::vector<TransitionId>>>; ///< instance and location
  ByPlace takingPart; ///< transitions with a part there
  ByPlace starting;   ///< those of them whose first part it is
};

} // namespace proskill::verify
