#pragma once

#include "verify/state/guard_tables.h"
#include "verify/state/run.h"
#include "verify/state/timing.h"
#include "verify/state/transition_set.h"

namespace proskill::verify {

/// Computes which transitions the discrete state allows. After a step it evaluates only the guards
/// that read what the step may have written.
class Enabling {
public:
  /// Skips the transitions in `dropped`.
  explicit Enabling(const System& system, const Bits& dropped = {});
  /// Bytes that its largest tables take at most.
  [[nodiscard]] static std::uint64_t mostBytes(const System& system);

  /// Computes the enabled transitions of any state.
  void compute(const Word* state, TransitionSet& enabled) const;
  /// Computes the enabled transitions of a state from those of its predecessor.
  /// \param enabled in: of the predecessor; out: of `state`
  void update(TransitionId fired, const Word* state, TransitionSet& enabled) const;
  /// Evaluates the transitions in `changed` again, after a cell that their guards read was written.
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
  /// Some transitions, all of one word of a set.
  struct Slice {
    std::uint32_t word = 0;
    Word bits = 0;
  };

  void findGuards();
  void findPlaces(const Bits& dropped);
  void findAffected(const Bits& dropped);
  void findCrowds();
  void computeByTables(const Word* state, TransitionSet& enabled) const;
  [[nodiscard]] bool isPossible(TransitionId transition, const Word* state) const;
  void look(TransitionId transition, const Word* state, TransitionSet& enabled) const;
  /// Whether many transitions start from a location.
  [[nodiscard]] bool isCrowded(InstanceId instance, std::size_t location) const;
  void lookAtPlace(InstanceId instance, const Word* state, TransitionSet& enabled) const;
  [[nodiscard]] std::size_t locationOf(InstanceId instance, const Word* state) const;

  /// The bit tests of a guard, in `tests`.
  struct Guard {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool isWhole = false; ///< the guard has no other condition
  };

  const System& system;
  GuardTables tables;
  std::vector<Guard> guards; ///< by transition
  std::vector<BitTest> tests;
  TransitionSet urgent;
  TransitionSet clocked;
  /// By transition, from its position in `affectedBy` to that of the next one: the transitions
  /// whose guards read what it writes, except locations of its own instances.
  std::vector<Slice> affected;
  std::vector<std::uint32_t> affectedBy;
  using ByPlace = std::vector<std::vector<std::vector<TransitionId>>>; ///< by instance and location
  ByPlace takingPart; ///< transitions with a part in this location
  ByPlace starting;   ///< those whose first part is in this location
  /// By instance and location: the transitions in which the instance takes part from there, and
  /// those of which all or none of the parts of the instance are there. Many transitions of one
  /// location, as a synchronisation of many processes has, are tried 64 at a time. Empty if no
  /// location has many.
  std::vector<std::vector<TransitionSet>> crowds;
  std::vector<std::vector<TransitionSet>> possible;
};

} // namespace proskill::verify
