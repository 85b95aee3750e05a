#pragma once

#include "verify/guide/goal_distance.h"
#include "verify/guide/random_walks.h"

#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace proskill::verify {

/// What leads a search. Without either, it is breadth-first.
struct Guide {
  GoalDistance* distance = nullptr; ///< to the only goal
  bool walks = false;               ///< at random

  [[nodiscard]] bool leads() const { return distance || walks; }
};

/// The nodes that a search has to expand. Without a guide they come in the order in which they
/// were found. With a distance, the node with the smallest estimate comes first, in turn among all
/// nodes and among those that a useful step leads to: Richter and Helmert, "Preferred operators and
/// deferred evaluation in satisficing planning", ICAPS 2009.
class Frontier {
public:
  using Node = std::uint32_t;

  /// \pre the guide's distance outlives this
  explicit Frontier(Guide guide) : distance(guide.distance) {
    if (guide.walks) walks.emplace();
  }

  /// Adds the next node. Nodes are numbered from 0 in the order in which they are added.
  /// \param lastStep the step that leads to it from the node that is expanded, or kNone
  void add(const Word* state, TransitionId lastStep);
  /// Returns the node to expand next. \pre some are left
  Node take();
  /// Notes the state of the node that is expanded, whose successors are added next.
  void expand(const Word* state);
  [[nodiscard]] Node left() const { return added - taken; }
  [[nodiscard]] Node takenCount() const { return taken; }

private:
  using Estimate = std::pair<std::uint32_t, Node>;
  using Queue = std::priority_queue<Estimate, std::vector<Estimate>, std::greater<>>;

  std::optional<Node> takeFrom(Queue& queue);

  GoalDistance* distance;
  std::optional<RandomWalks> walks;
  Queue all;
  Queue useful; ///< those that a useful step leads to
  bool isTurnOfUseful = false;
  std::vector<bool> isTaken; ///< by node
  Bits usefulSteps;          ///< of the node that is expanded
  Node added = 0;
  Node taken = 0;
};

} // namespace proskill::verify
