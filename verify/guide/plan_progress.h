#pragma once

#include "verify/model/system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace proskill::verify {

/// How far the nodes of a search have followed a plan: a run of a part of the system that lacks
/// what the others have to do meanwhile. Each instance of the plan takes its own steps in their
/// order; in which order those of different instances come is left to the search. Events of the
/// environment could happen at any time, so they wait for what comes before them in the plan.
/// A plan leads a search and proves nothing.
class PlanProgress {
public:
  using Node = std::uint32_t;

  /// \param plan steps of the system \pre the system outlives this
  PlanProgress(const System& system, const std::vector<TransitionId>& plan);

  /// Notes the node whose successors are added next.
  void expand(Node node) { expanded = node; }
  /// Adds the next node. Nodes are numbered from 0 in the order in which they are added.
  /// \param steps those that lead to it from the node that is expanded
  /// \return the number of steps of the plan that are left, and of those that were taken instead
  std::uint32_t add(std::span<const TransitionId> steps);

private:
  using RoleId = std::uint32_t;

  /// An event, and how many steps each instance takes before it in the plan.
  struct Event {
    TransitionId step = 0;
    std::vector<std::uint32_t> after; ///< by role
  };

  [[nodiscard]] bool moves(PathId path) const;
  [[nodiscard]] bool isEvent(TransitionId step) const;
  [[nodiscard]] RoleId roleFor(InstanceId instance);
  [[nodiscard]] bool isTime(const Event& event, const std::uint32_t* places) const;
  void follow(TransitionId step, std::uint32_t* node) const;
  void followEvent(TransitionId step, std::uint32_t* node) const;

  const System& system;
  std::vector<std::vector<TransitionId>> roles; ///< steps of each instance of the plan
  std::vector<RoleId> roleOf;                   ///< by instance, or kNone
  std::vector<Event> events;
  std::size_t width = 0;           ///< of what is kept of a node
  std::vector<std::uint32_t> kept; ///< by node: what add() returned, the number of events that have
                                   ///< happened, and the place of each role
  Node expanded = kNone;
};

} // namespace proskill::verify
