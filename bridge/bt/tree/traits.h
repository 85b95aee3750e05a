#pragma once

#include "bridge/bt/tree/tree.h"
#include "bridge/text/leaves.h"

#include <span>

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
  /// The same without regard to its own preconditions.
  [[nodiscard]] Ends endsInside(const Node& node) const;
  /// Whether it is made of conditions alone, so that no tick finds it running.
  [[nodiscard]] bool isPure(const Node& node) const;
  /// The same without regard to its own preconditions.
  [[nodiscard]] bool isPureInside(const Node& node) const;
  /// With what it surely can end in the tick that starts it.
  [[nodiscard]] Ends endsAtOnce(const Node& node) const;
  /// Whether it always ends in the tick that starts it, and its parts one after the other.
  [[nodiscard]] bool isInstant(const Node& node) const;
  /// Whether it contains an action that always ends in the tick that starts it.
  [[nodiscard]] bool hasInstantAction(const Node& node) const;
  /// Whether it may end in the tick that starts it although no action ends in that tick.
  [[nodiscard]] bool mayEndAtOnce(const Node& node) const;

private:
  [[nodiscard]] Ends inOrderAtOnce(const Node& node) const;
  [[nodiscard]] Ends leafEnds(const Node& node) const;
  [[nodiscard]] Ends all(std::span<const Node> inOrder) const;
  [[nodiscard]] Ends any(const Node& node) const;
  [[nodiscard]] Ends together(const Node& node) const;
  [[nodiscard]] Ends parallel(const Node& node) const;
  [[nodiscard]] Ends parallelAll(const Node& node) const;
  [[nodiscard]] Ends choice(const Node& node) const;
  [[nodiscard]] Ends loop(const Node& node) const;
  [[nodiscard]] Ends orElse(const Node& node) const;
  [[nodiscard]] Ends tryCatch(const Node& node) const;
  [[nodiscard]] Ends pauseResume(const Node& node) const;

  const Leaves& leaves;
};

/// The conditions of a Parallel to end, between 1 and its number of children.
struct Thresholds {
  std::int64_t successes = 1;
  std::int64_t failures = 1;
};
/// By the ports of version 4, of version 3 (`success_threshold`, `failure_threshold`), or of its
/// first releases (`threshold`, which says both).
/// \return nothing if a port is not a number, or not a number that BehaviorTree.CPP accepts.
[[nodiscard]] std::optional<Thresholds> thresholdsOf(const Node& parallel);
/// `max_failures` of a ParallelAll, or nothing.
[[nodiscard]] std::optional<std::int64_t> failuresOf(const Node& parallelAll);
/// The integer in a port; nothing if it is not one.
[[nodiscard]] std::optional<std::int64_t> numberIn(const std::string& port);
/// The number of rounds of a Repeat or a RetryUntilSuccessful; -1: without end. Nothing if an entry
/// of the blackboard says it.
[[nodiscard]] std::optional<std::int64_t> roundsOf(const Node& loop);
/// The number of retries of a RecoveryNode. Nothing if it is not a number.
[[nodiscard]] std::optional<std::int64_t> retriesOf(const Node& recovery);
/// The number of elements of a queue that a port spells out. Nothing if the blackboard has it.
[[nodiscard]] std::optional<std::int64_t> elementsIn(const Node& queue);
/// What a node returns in place of the result of its child.
enum class Otherwise : std::uint8_t { Success, Failure, Skipped, Running };
/// Of a Precondition whose test is false, or of a Queue that is empty. Nothing if the port has
/// another value.
[[nodiscard]] std::optional<Otherwise> otherwiseOf(const Node& node);
/// Whether a RunOnce is skipped when it has run. Nothing if the port is not a truth value.
[[nodiscard]] std::optional<bool> thenSkips(const Node& runOnce);
/// Whether scripts decide about a node before it is ticked, or while it runs.
[[nodiscard]] bool hasPrecondition(const Node& node);
/// Whether its parent may go on without it.
[[nodiscard]] bool maySkip(const Node& node);
/// The same without regard to its own preconditions: it skips by itself, or passes on that its
/// children are skipped.
[[nodiscard]] bool maySkipInside(const Node& node);

} // namespace proskill::bridge::bt
