#pragma once

#include "verify/space/column.h"
#include "verify/space/parents.h"
#include "verify/space/state_tree.h"
#include "verify/space/zone_cover.h"
#include "verify/state/enabled.h"
#include "verify/state/timing.h"

#include <array>

namespace proskill::verify {

using NodeIndex = std::uint32_t;

/// The explored part of the zone graph. A node is a discrete state with a zone. What is the same
/// for all nodes or states takes no memory: see Column.
class ZoneGraph {
public:
  /// \param dropped transitions that are skipped
  ZoneGraph(const System& system, const Bits& dropped, Extrapolation extrapolation);

  Enabling enabling;
  Timing timing;
  StateTree states;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(zones.size()); }
  [[nodiscard]] StateId stateOf(NodeIndex node) const { return node - lags.at(node); }
  [[nodiscard]] ZoneId zoneOf(NodeIndex node) const { return zones.at(node); }
  /// The newest node of a state.
  [[nodiscard]] NodeIndex headOf(StateId state) const { return state + heads.at(state); }
  /// Whether a later zone includes that of the node, so that it is not expanded.
  [[nodiscard]] bool isSubsumed(NodeIndex node) const { return subsumed.contains(node); }
  [[nodiscard]] SignatureId signatureOf(StateId state) const { return signatures.at(state); }
  /// The node from which a node was first reached; kNone for the initial one.
  [[nodiscard]] NodeIndex parentOf(NodeIndex node) const { return parents.of(node); }
  /// The step from there; kNone if it is not kept. Without time, a search is seldom deep, so that a
  /// trace finds the steps again.
  [[nodiscard]] TransitionId stepTo(NodeIndex node) const { return steps.at(node) - 1; }

  /// Call this for each node that is taken from the frontier, in their order. The nodes that are
  /// added next are its children.
  void expand(NodeIndex node) { parents.expand(node); }
  /// Adds a state that states.add() has just found to be new.
  void addState(SignatureId signature);
  /// Adds a node to a state.
  /// \param step that leads to it from the node that is expanded, or kNone
  /// \param replaces whether the zone replaces those that it includes
  /// \pre no node of the state covers the zone
  void addNode(StateId state, ZoneId zone, TransitionId step, bool replaces);
  /// Whether nodes of the state include a zone. Without inclusion: whether one of them has it.
  /// Several threads may call this at once, with zones of their own.
  /// \param state may be RootTable::kStored if the system has no clocks
  [[nodiscard]] bool covers(StateId state, std::span<const Bound> zone, bool inclusion) const;

  /// A zone that includes this one and that of the newest node of the state: the hull of both, or
  /// a wider one if so many were made for the state.
  [[nodiscard]] ZoneId hullWith(StateId state, ZoneId zone, std::uint8_t most);

  [[nodiscard]] std::uint64_t bytes() const;
  /// Bytes that the next few steps may allocate at once, because a table is nearly full.
  [[nodiscard]] std::uint64_t growth() const;

private:
  [[nodiscard]] NodeIndex nextOf(NodeIndex node) const {
    const std::uint32_t step = links.at(node);
    return step == 0 ? kNone : node - step;
  }
  [[nodiscard]] NodeIndex removeSubsumed(StateId state, ZoneId zone);
  void addToCover(StateId state, NodeIndex first, ZoneId zone);
  [[nodiscard]] bool hasMany(StateId state) const;
  void addToIndex(StateId state, NodeIndex node);
  void addToIndex(NodeIndex node);
  [[nodiscard]] bool isInIndex(StateId state, std::span<const Bound> zone) const;

  [[nodiscard]] std::array<const Column*, 7> columns() const {
    return {&signatures, &heads, &coverOf, &lags, &zones, &links, &steps};
  }

  bool keepsSteps;
  Column signatures; ///< by state
  Column heads;      ///< by state: its newest node minus its number
  Column coverOf;    ///< by state: 1 + index in `unions`, for states with many nodes
  std::vector<ZoneCover> unions;
  std::uint64_t coverBytes = 0;
  Bits indexed;                     ///< states with many nodes, none of which replaces another
  std::optional<NumberTable> index; ///< their nodes, by state and zone
  Column lags;                      ///< by node: its number minus that of its state
  Column zones;                     ///< by node
  Column links;  ///< by node: its number minus that of the next older node of the state; 0: none
  Column steps;  ///< by node: 1 + the step to it; 0 if it is not kept
  Bits subsumed; ///< nodes
  std::vector<std::uint8_t> hulls; ///< by state: how many were made; used by hullWith only
  Parents parents;
};

} // namespace proskill::verify
