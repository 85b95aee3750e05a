#pragma once

#include "verify/ctl/zone_union.h"
#include "verify/explore/explorer.h"
#include "verify/explore/search.h"

#include <map>

namespace proskill::verify {

/// Searches for reachable moments from which a condition can never be seen any more, in a state or
/// in a step.
///
/// For each discrete state, the set of clock values from which some run leads to the condition is
/// computed backwards, as the least fixed point of predecessors by steps and by the passing of time
/// (Alur, Courcoubetis, Dill, "Model-checking in dense real-time", 1993; Henzinger, Nicollin,
/// Sifakis, Yovine, "Symbolic model checking for real-time systems", 1994). This is exact for every
/// value, and does not depend on how the stored zones were abstracted. A stored zone that is not
/// included in this set has a lost value: under Extra+M every stored value has a reached twin with
/// the same runs.
///
/// Once all stored values of a state are known to be good, the state counts as good for all values:
/// only stored values are asked about, and their steps lead to stored values.
class LostStates {
public:
  /// \pre the exploration is complete, and used Extra+M or no extrapolation of bounded clocks; the
  /// reductions suit a monitor that reads `condition` in every state and step
  LostStates(const System& system, const Reductions& reductions, NodeId condition,
             Explorer& explorer, LimitWatch& limits);

  /// The steps to a lost moment, and where its clocks are then. \throw LimitMet
  [[nodiscard]] std::optional<Evidence> find();

private:
  /// A step, with the steps that are fired alone after it, to a stored state.
  struct Arc {
    StateId from = 0;
    TransitionId transition = 0;
    std::uint32_t clocks = 0; ///< index in `kept`
  };

  /// The values of a state from which the condition can be reached.
  struct Good {
    ZoneUnion zones;
    bool all = false; ///< every stored value
  };

  void findArcs();
  void findArcsOf(StateId state);
  void follow(StateId state, TransitionId transition, const std::vector<Word>& chosen);
  [[nodiscard]] std::uint32_t numberOf(std::vector<std::uint32_t> clocks);
  [[nodiscard]] bool shows(const std::vector<Word>& before, const std::vector<Word>& after) const;

  void grow(StateId state, Dbm zone);
  void growBefore(const Arc& arc, const Dbm& zone);
  void growAll(StateId state);
  [[nodiscard]] bool hasAll(StateId state) const;
  [[nodiscard]] Dbm zoneOf(NodeIndex node) const {
    return graph.timing.zones().zone(graph.zoneOf(node));
  }
  [[nodiscard]] Dbm valuesOf(StateId state) const;
  [[nodiscard]] std::optional<Dbm> before(const Arc& arc, const Dbm& zone) const;
  /// The values that let the transition fire now or later, from values that let it fire.
  void addPast(StateId state, TransitionId transition, std::optional<Dbm> zone);
  [[nodiscard]] std::optional<Evidence> evidenceAt(NodeIndex node);
  void check();

  const System& system;
  const Reductions& reductions;
  NodeId condition;
  Explorer& explorer;
  ZoneGraph& graph;
  LimitWatch& limits;
  Walker walker;
  std::size_t count;                           ///< of stored states
  std::vector<std::vector<NodeIndex>> nodesOf; ///< by state, without those that are subsumed
  std::vector<std::vector<Arc>> arcsTo;
  std::vector<std::vector<std::uint32_t>> kept; ///< by number: argument of Dbm::over
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;
  std::vector<Good> good;
  std::vector<std::pair<StateId, Dbm>> todo;
  std::vector<Word> loaded;
  TransitionSet enabled;
  StepLog log;
  StateTree::Path path;
  std::uint64_t zonesAdded = 0;
};

} // namespace proskill::verify
