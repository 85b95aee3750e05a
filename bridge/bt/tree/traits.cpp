#include "bridge/bt/tree/traits.h"

#include <algorithm>
#include <charconv>

namespace proskill::bridge::bt {
namespace {

std::int64_t sizeOf(const Node& node) { return static_cast<std::int64_t>(node.children.size()); }

} // namespace

std::optional<std::int64_t> numberIn(const std::string& port) {
  std::int64_t number = 0;
  const auto* end = port.data() + port.size();
  const auto read = std::from_chars(port.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end || port.empty()) return std::nullopt;
  return number;
}

std::optional<Thresholds> thresholdsOf(const Node& parallel) {
  const auto count = sizeOf(parallel);
  auto successes = numberIn(parallel.port("success_count", "-1"));
  auto failures = numberIn(parallel.port("failure_count", "1"));
  if (!successes || !failures) return std::nullopt;
  if (*successes < 0) *successes += count + 1;
  if (*failures < 0) *failures += count + 1;
  if (*successes < 1 || *successes > count || *failures < 1 || *failures > count)
    return std::nullopt;
  return Thresholds{*successes, std::min(*failures, count - *successes + 1)};
}

std::optional<std::int64_t> failuresOf(const Node& parallelAll) {
  auto failures = numberIn(parallelAll.port("max_failures", "1"));
  const auto count = sizeOf(parallelAll);
  if (failures && *failures < 0) *failures += count + 1;
  if (!failures || *failures < 1 || *failures > count) return std::nullopt;
  return failures;
}

std::optional<std::int64_t> roundsOf(const Node& loop) {
  return numberIn(loop.port(loop.kind == Kind::Repeat ? "num_cycles" : "num_attempts"));
}

bool hasPrecondition(const Node& node) {
  return node.ports.contains("_failureIf") || node.ports.contains("_successIf");
}

Ends Traits::ends(const Node& node) const {
  auto ends = inner(node);
  if (node.ports.contains("_failureIf")) ends.failure = true;
  if (node.ports.contains("_successIf")) ends.success = true;
  return ends;
}

Ends Traits::inner(const Node& node) const {
  const auto child = [&] { return ends(node.children.front()); };
  switch (node.kind) {
  case Kind::Action:
  case Kind::Condition: return leafEnds(node);
  case Kind::Script:
  case Kind::Sleep:
  case Kind::AlwaysSuccess: return {true, false};
  case Kind::AlwaysFailure: return {false, true};
  case Kind::Sequence:
  case Kind::SequenceWithMemory:
  case Kind::ReactiveSequence: return all(node);
  case Kind::Fallback:
  case Kind::ReactiveFallback: return any(node);
  case Kind::Parallel: return parallel(node);
  case Kind::ParallelAll: return parallelAll(node);
  case Kind::IfThenElse:
  case Kind::WhileDoElse:
  case Kind::Switch: return choice(node);
  case Kind::Inverter: return {child().failure, child().success};
  case Kind::ForceSuccess: return {child().success || child().failure, false};
  case Kind::ForceFailure: return {false, child().success || child().failure};
  case Kind::Repeat:
  case Kind::Retry:
  case Kind::KeepRunning: return loop(node);
  case Kind::Timeout: return {child().success, true};
  case Kind::Delay:
  case Kind::SubTree: return child();
  }
  return {};
}

Ends Traits::leafEnds(const Node& node) const {
  const auto& leaf = leaves.of(node);
  return {leaf.succeeds, leaf.fails};
}

Ends Traits::all(const Node& node, std::size_t from) const {
  Ends result{true, false};
  for (std::size_t i = from; i < node.children.size() && result.success; ++i) {
    const auto child = ends(node.children[i]);
    result.failure = result.failure || child.failure;
    result.success = child.success;
  }
  return result;
}

Ends Traits::any(const Node& node) const {
  Ends result{false, true};
  for (std::size_t i = 0; i < node.children.size() && result.failure; ++i) {
    const auto child = ends(node.children[i]);
    result.success = result.success || child.success;
    result.failure = child.failure;
  }
  return result;
}

Ends Traits::parallel(const Node& node) const {
  const auto thresholds = thresholdsOf(node).value_or(Thresholds{});
  const auto succeeding =
      std::ranges::count_if(node.children, [&](const Node& child) { return ends(child).success; });
  const auto failing =
      std::ranges::count_if(node.children, [&](const Node& child) { return ends(child).failure; });
  return {succeeding >= thresholds.successes, failing >= thresholds.failures};
}

Ends Traits::parallelAll(const Node& node) const {
  const auto needed = failuresOf(node).value_or(1);
  std::int64_t certain = 0;
  std::int64_t possible = 0;
  for (const auto& child : node.children) {
    const auto end = ends(child);
    if (!end.success && !end.failure) return {false, false};
    if (!end.success) ++certain;
    if (end.failure) ++possible;
  }
  return {certain < needed, possible >= needed};
}

Ends Traits::choice(const Node& node) const {
  const bool isSwitch = node.kind == Kind::Switch;
  Ends result{false, !isSwitch && node.children.size() == 2};
  for (std::size_t i = isSwitch ? 0 : 1; i < node.children.size(); ++i) {
    const auto child = ends(node.children[i]);
    result.success = result.success || child.success;
    result.failure = result.failure || child.failure;
  }
  return result;
}

Ends Traits::loop(const Node& node) const {
  const auto child = ends(node.children.front());
  if (node.kind == Kind::KeepRunning) return {false, child.failure};
  const bool endless = roundsOf(node) == -1;
  if (node.kind == Kind::Repeat) return {!endless && child.success, child.failure};
  return {child.success, !endless && child.failure};
}

bool Traits::isPure(const Node& node) const {
  if (hasPrecondition(node)) return false;
  switch (node.kind) {
  case Kind::Condition:
  case Kind::Script:
  case Kind::AlwaysSuccess:
  case Kind::AlwaysFailure: return true;
  case Kind::Sequence:
  case Kind::ReactiveSequence:
  case Kind::Fallback:
  case Kind::ReactiveFallback:
  case Kind::IfThenElse:
  case Kind::Inverter:
  case Kind::ForceSuccess:
  case Kind::ForceFailure:
  case Kind::SubTree:
    return std::ranges::all_of(node.children, [&](const Node& child) { return isPure(child); });
  case Kind::Action:
  case Kind::Sleep:
  case Kind::SequenceWithMemory:
  case Kind::Parallel:
  case Kind::ParallelAll:
  case Kind::WhileDoElse:
  case Kind::Switch:
  case Kind::Repeat:
  case Kind::Retry:
  case Kind::KeepRunning:
  case Kind::Timeout:
  case Kind::Delay: return false;
  }
  return false;
}

bool Traits::mayEndAtOnce(const Node& node) const {
  if (isPure(node) || hasPrecondition(node)) return true;
  if (node.kind == Kind::Action) return leaves.of(node).isInstant();
  return std::ranges::any_of(node.children, [&](const Node& child) { return mayEndAtOnce(child); });
}

} // namespace proskill::bridge::bt
