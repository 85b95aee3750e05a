#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/state/enabled.h"

#include <map>

namespace proskill::verify {

/// Partial order reduction by stubborn sets with a single enabled transition: an urgent one that no
/// other transition can interfere with before it fires. Valmari, "Stubborn sets for reduced state
/// space generation", 1991; Bønneland, Jensen, Larsen, Muñiz, Srba, "Start pruning when time gets
/// urgent: partial order reduction for timed systems", CAV 2018, shows that urgency makes the
/// untimed theory applicable.
class StubbornSets {
public:
  /// \throw LimitMet
  StubbornSets(const System& system, const std::vector<Goal>& goals, const Bits& dropped,
               LimitWatch& limits);
  /// The same for another thread, with caches of its own. \pre `from` outlives it
  StubbornSets(const StubbornSets& from, LimitWatch& watch) : StubbornSets(from) {
    limits = &watch;
  }

  /// A transition that may be fired alone in this state; kNone if there is none.
  /// \throw LimitMet
  [[nodiscard]] TransitionId pick(const Word* state, const TransitionSet& enabled) const;

private:
  /// A condition of a guard, and the transitions that may make it true.
  struct Condition {
    NodeId node = 0;
    const TransitionSet* helpers = nullptr;
  };

  /// Explains why a transition is disabled.
  struct Needs {
    std::vector<std::pair<InstanceId, std::uint32_t>> locations;
    std::vector<Condition> conditions;
    bool tentative = false;
    TransitionSet anyHelper; ///< transitions that write something on which its guard depends
  };

  struct Touching;

  void findDependence(const Touching& touching, const Bits& dropped);
  void findCandidates(const Touching& touching, const std::vector<Goal>& goals,
                      const Bits& dropped);
  void findNeeds(const Touching& touching, const Bits& dropped);
  void findWays(const Bits& dropped);
  const TransitionSet& helpersOf(const Touching& touching, NodeId node);
  [[nodiscard]] TransitionSet alwaysPossible() const;
  [[nodiscard]] const TransitionSet& waysTo(InstanceId instance, std::uint32_t from,
                                            std::uint32_t target) const;
  [[nodiscard]] const TransitionSet& elsewhere(InstanceId instance, std::uint32_t from) const;
  [[nodiscard]] bool isLeftInside(InstanceId instance, std::uint32_t from) const;
  [[nodiscard]] bool isStubbornAlone(TransitionId transition, const Word* state,
                                     const TransitionSet& enabled) const;
  [[nodiscard]] const TransitionSet* reasonFor(TransitionId transition, const Word* state,
                                               const TransitionSet& enabled) const;

  const System& system;
  LimitWatch* limits;
  TransitionSet none;
  TransitionSet candidates;             ///< transitions that may be safe in some state
  std::vector<TransitionSet> dependent; ///< by candidate: the transitions that depend on it
  std::vector<Needs> needs;             ///< by transition
  std::map<NodeId, TransitionSet> helpers;

  struct Move {
    TransitionId transition;
    std::uint32_t to;
  };
  std::vector<std::vector<std::vector<Move>>> moves; ///< by instance and location
  /// By instance: the transitions in which it takes part, and from which location.
  std::vector<std::vector<std::pair<TransitionId, std::uint32_t>>> partners;
  std::vector<std::vector<Bits>> reached; ///< by instance and location: reachable locations
  /// Cache of waysTo, by instance and two locations; empty where it is not known.
  mutable std::vector<std::vector<std::vector<TransitionSet>>> ways;
  mutable std::vector<std::vector<TransitionSet>> others; ///< the same of elsewhere
  mutable TransitionSet stubborn; ///< a closure, and those of its transitions that were followed
  mutable TransitionSet done;
};

} // namespace proskill::verify
