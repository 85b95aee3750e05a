#pragma once

#include "bridge/bt/tree/leaves.h"

namespace proskill::bridge::bt {

/// With what a node can end.
struct Ends {
  bool success = false;
  bool failure = false;
};

/// What the structure of a tree says about its nodes.
class Traits {
public:
  explicit Traits(const Leaves& leaves) : leaves(leaves) {}

  [[nodiscard]] Ends ends(const Node& node) const;
  /// Whether it is made of conditions alone, so that no tick finds it running.
  [[nodiscard]] bool isPure(const Node& node) const;
  /// Whether it may end in the tick that starts it although no action ends in that tick.
  [[nodiscard]] bool mayEndAtOnce(const Node& node) const;

private:
  [[nodiscard]] Ends leafEnds(const Node& node) const;
  [[nodiscard]] Ends all(const Node& node, std::size_t from = 0) const;
  [[nodiscard]] Ends any(const Node& node) const;
  [[nodiscard]] Ends parallel(const Node& node) const;
  [[nodiscard]] Ends parallelAll(const Node& node) const;
  [[nodiscard]] Ends choice(const Node& node) const;
  [[nodiscard]] Ends loop(const Node& node) const;
  [[nodiscard]] Ends inner(const Node& node) const;

  const Leaves& leaves;
};

/// The conditions of a Parallel to end, between 1 and its number of children.
struct Thresholds {
  std::int64_t successes = 1;
  std::int64_t failures = 1;
};
/// Nothing if a port is not a number, or not a number that BehaviorTree.CPP accepts.
[[nodiscard]] std::optional<Thresholds> thresholdsOf(const Node& parallel);
/// `max_failures` of a ParallelAll, or nothing.
[[nodiscard]] std::optional<std::int64_t> failuresOf(const Node& parallelAll);
/// The integer in a port; nothing if it is not one.
[[nodiscard]] std::optional<std::int64_t> numberIn(const std::string& port);
/// The number of rounds of a Repeat or a RetryUntilSuccessful; -1: without end. Nothing if an entry
/// of the blackboard says it.
[[nodiscard]] std::optional<std::int64_t> roundsOf(const Node& loop);
/// Whether scripts decide about a node before it is ticked.
[[nodiscard]] bool hasPrecondition(const Node& node);

} // namespace proskill::bridge::bt
