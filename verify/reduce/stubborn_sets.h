#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/state/enabled.h"

#include <map>
#include <tuple>

namespace proskill::verify {

/// Partial order reduction by stubborn sets of which one transition is enabled: an urgent one that
/// nothing else can disturb, or be disturbed by, before it fires. Valmari, "Stubborn sets for
/// reduced state space generation", 1991; Bønneland, Jensen, Larsen, Muñiz, Srba, "Start pruning
/// when time gets urgent: partial order reduction for timed systems", CAV 2018, for why urgency
/// lets the untimed theory be used.
class StubbornSets {
public:
  /// \throw LimitMet
  StubbornSets(const System& system, const std::vector<Goal>& goals, const Bits& dropped,
               LimitWatch& limits);

  /// A transition that may be fired alone from this state; kNone where there is none.
  /// \throw LimitMet
  [[nodiscard]] TransitionId pick(const Word* state, const TransitionSet& enabled) const;

private:
  /// A condition of a guard, and who may make it true.
  struct Condition {
    NodeId node = 0;
    const TransitionSet* helpers = nullptr;
  };

  /// What has to be known of a transition to tell why it is disabled.
  struct Needs {
    std::vector<std::pair<InstanceId, std::uint32_t>> locations;
    std::vector<Condition> conditions;
    bool tentative = false;
    TransitionSet anyHelper; ///< who writes what its being enabled depends on
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
  [[nodiscard]] bool isStubbornAlone(TransitionId transition, const Word* state,
                                     const TransitionSet& enabled) const;
  [[nodiscard]] const TransitionSet* reasonFor(TransitionId transition, const Word* state,
                                               const TransitionSet& enabled,
                                               const TransitionSet& stubborn) const;

  const System& system;
  LimitWatch& limits;
  TransitionSet none;
  TransitionSet candidates;             ///< that may ever be safe
  std::vector<TransitionSet> dependent; ///< by candidate
  std::vector<Needs> needs;             ///< by transition
  std::map<NodeId, TransitionSet> helpers;

  struct Move {
    TransitionId transition;
    std::uint32_t to;
  };
  std::vector<std::vector<std::vector<Move>>> moves; ///< by instance and location
  std::vector<std::vector<Bits>> reached;            ///< by instance and location: locations
  mutable std::map<std::tuple<InstanceId, std::uint32_t, std::uint32_t>, TransitionSet> ways;
};

} // namespace proskill::verify
