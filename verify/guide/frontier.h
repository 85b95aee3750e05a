#pragma once

#include "verify/guide/goal_distance.h"
#include "verify/guide/novelty.h"
#include "verify/guide/plan_progress.h"
#include "verify/guide/random_walks.h"

#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace proskill::verify {

/// What leads a search. Without either, it is breadth-first.
struct Guide {
  GoalDistance* distance = nullptr; ///< to the only goal
  bool walks = false;               ///< at random
  Novelty* novelty = nullptr;       ///< of states
  PlanProgress* plan = nullptr;     ///< requires novelty

  [[nodiscard]] bool leads() const { return distance || walks || novelty || plan; }
};

/// The nodes that a search has to expand. Without a guide they come in the order in which they
/// were found. With novelty, the newest come first. With a plan, the node that has come furthest
/// along it comes first, in turn with the newest. With a distance, the node with the smallest
/// estimate comes first, in turn among all nodes, among those that a useful step leads to, and,
/// with novelty, among those that are new where as much of the goal is left: Richter and Helmert,
/// "Preferred operators and deferred evaluation in satisficing planning", ICAPS 2009.
class Frontier {
public:
  using Node = std::uint32_t;

  /// \pre what the guide refers to outlives this
  explicit Frontier(Guide guide)
      : distance(guide.distance), novelty(guide.novelty), plan(guide.plan) {
    if (guide.walks) walks.emplace();
  }

  /// Adds the next node. Nodes are numbered from 0 in the order in which they are added.
  /// \param lastStep the step that leads to it from the node that is expanded, or kNone
  /// \param steps all of them, with those that are fired alone after it; only a plan needs these
  void add(const Word* state, TransitionId lastStep, std::span<const TransitionId> steps = {});
  /// Returns the node to expand next. \pre some are left
  Node take();
  /// Notes the state of the node that is expanded, whose successors are added next.
  void expand(const Word* state);
  [[nodiscard]] Node left() const { return added - taken; }
  [[nodiscard]] Node takenCount() const { return taken; }

private:
  using Estimate = std::pair<std::uint32_t, Node>;
  template <class Rank> using Queue = std::priority_queue<Rank, std::vector<Rank>, std::greater<>>;
  /// How new a node is, how much of the goal is left there, and the estimate.
  using Newness = std::tuple<Novelty::Degree, std::uint32_t, Estimate>;

  /// How much of a plan is left, how new a node is there, and the node, the later the smaller.
  using Lead = std::tuple<std::uint32_t, Novelty::Degree, Estimate>;

  void addByPlan(const Word* state, std::span<const TransitionId> steps, Node node);
  [[nodiscard]] Node takeByPlan();
  void addByDistance(const Word* state, TransitionId lastStep, Node node);
  [[nodiscard]] Node takeByDistance();
  template <class Rank> std::optional<Node> takeFrom(Queue<Rank>& queue);
  [[nodiscard]] static Node nodeOf(const Estimate& rank) { return rank.second; }
  [[nodiscard]] static Node nodeOf(const Newness& rank) { return nodeOf(std::get<2>(rank)); }
  [[nodiscard]] static Node nodeOf(const Lead& rank) { return nodeOf(std::get<2>(rank)); }

  GoalDistance* distance;
  Novelty* novelty;
  PlanProgress* plan;
  std::optional<RandomWalks> walks;
  Queue<Estimate> all;
  Queue<Estimate> useful; ///< those that a useful step leads to
  Queue<Newness> newest;
  Queue<Lead> furthest; ///< along the plan
  std::uint32_t turns = 0;
  std::vector<bool> isTaken; ///< by node
  Bits usefulSteps;          ///< of the node that is expanded
  Node added = 0;
  Node taken = 0;
};

} // namespace proskill::verify
