#pragma once

#include "verify/explore/explorer.h"
#include "verify/reduce/reductions.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// Cycles of some steps among the discrete states of an explored graph.
class StepCycles {
public:
  /// \param reductions with which the graph was explored; at most live variables
  /// \param repeating the steps that cycles are made of: none of them has a clock
  /// \pre the arguments outlive this
  /// \throw LimitMet
  StepCycles(const System& system, const Reductions& reductions, const ZoneGraph& graph,
             const Bits& repeating, LimitWatch& limits);

  /// Whether the graph has all states that the steps lead to. If not, there may be more cycles.
  [[nodiscard]] bool areAll() const { return !isLacking; }
  /// The instances that take part in a step on a cycle.
  [[nodiscard]] const Bits& moving() const { return onCycles; }

  struct Cycle {
    StateId start = 0;
    Steps steps;
  };
  /// A cycle with a step of the instance. \pre the instance is one of moving()
  [[nodiscard]] Cycle cycleOf(InstanceId instance) const;

private:
  struct Arc {
    StateId to = 0;
    TransitionId step = 0;
  };

  void addArcs(StateId from, const Bits& repeating);
  void sortInstances();
  [[nodiscard]] bool isOnCycle(StateId from, const Arc& arc) const {
    return component[from] == component[arc.to];
  }
  [[nodiscard]] bool moves(const Arc& arc, InstanceId instance) const;
  [[nodiscard]] Steps way(StateId from, StateId to) const;

  const System& system;
  const Reductions& reductions;
  const ZoneGraph& graph;
  LimitWatch& limits;
  std::vector<std::vector<Arc>> arcs; ///< by state
  std::vector<std::uint32_t> component;
  Bits onCycles;
  bool isLacking = false;
  // of the state whose arcs are added:
  std::vector<Word> state;
  std::vector<Word> next;
  TransitionSet enabled;
  StateTree::Path path;
  StepLog log;
};

} // namespace proskill::verify
