#include "bridge/bt/tree/traits.h"

#include <algorithm>
#include <charconv>

namespace proskill::bridge::bt {
namespace {

std::int64_t sizeOf(const Node& node) { return static_cast<std::int64_t>(node.children.size()); }

Ends inverted(Ends ends) { return {ends.failure, ends.success}; }
bool isEnding(Ends ends) { return ends.success || ends.failure; }

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
  const auto oldest = parallel.port("threshold");
  const auto old = parallel.port("success_threshold", oldest.empty() ? "-1" : oldest);
  const auto oldFailures = parallel.port("failure_threshold", oldest.empty() ? "1" : "-1");
  auto successes = numberIn(parallel.port("success_count", old));
  auto failures = numberIn(parallel.port("failure_count", oldFailures));
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

std::optional<std::int64_t> retriesOf(const Node& recovery) {
  return numberIn(recovery.port("number_of_retries", "1"));
}

std::optional<std::int64_t> elementsIn(const Node& queue) {
  const auto elements = queue.port("queue");
  if (elements.empty() || elements.starts_with('{')) return std::nullopt;
  return std::ranges::count(elements, ';') + 1;
}

std::optional<Otherwise> otherwiseOf(const Node& node) {
  if (node.id == "SkipUnlessUpdated") return Otherwise::Skipped;
  if (node.id == "WaitValueUpdate") return Otherwise::Running;
  if (node.id == "SingleTrigger") return Otherwise::Failure;
  const bool isQueue = node.kind == Kind::Queue;
  const auto result = isQueue ? node.port("if_empty", "SUCCESS") : node.port("else", "FAILURE");
  if (result == "SUCCESS") return Otherwise::Success;
  if (result == "FAILURE") return Otherwise::Failure;
  if (result == "SKIPPED") return Otherwise::Skipped;
  if (result == "RUNNING" && !isQueue) return Otherwise::Running;
  return std::nullopt;
}

std::optional<bool> thenSkips(const Node& runOnce) {
  const auto value = runOnce.port("then_skip", "true");
  if (isTrue(value)) return true;
  if (value == "false" || value == "False" || value == "FALSE" || value == "0") return false;
  return std::nullopt;
}

bool hasPrecondition(const Node& node) {
  const auto has = [&](const char* port) { return node.ports.contains(port); };
  return has("_failureIf") || has("_successIf") || has("_skipIf") || has("_while");
}

bool maySkipInside(const Node& node) {
  switch (node.kind) {
  case Kind::Precondition:
    return otherwiseOf(node) == Otherwise::Skipped || maySkip(node.children.front());
  case Kind::RunOnce: return thenSkips(node).value_or(true) || maySkip(node.children.front());
  case Kind::Queue: return otherwiseOf(node) == Otherwise::Skipped;
  case Kind::Inverter:
  case Kind::ForceSuccess:
  case Kind::ForceFailure:
  case Kind::SubTree:
  case Kind::Rate:
  case Kind::Sequence:
  case Kind::Fallback:
  case Kind::ReactiveSequence:
  case Kind::ReactiveFallback: return std::ranges::all_of(node.children, maySkip);
  case Kind::TryCatch: return std::all_of(node.children.begin(), node.children.end() - 1, maySkip);
  case Kind::IfThenElse:
    return std::any_of(node.children.begin() + 1, node.children.end(), maySkip);
  case Kind::Action:
  case Kind::Condition:
  case Kind::Script:
  case Kind::Sleep:
  case Kind::AlwaysSuccess:
  case Kind::AlwaysFailure:
  case Kind::SequenceWithMemory:
  case Kind::Parallel:
  case Kind::ParallelAll:
  case Kind::WhileDoElse:
  case Kind::Switch:
  case Kind::Repeat:
  case Kind::Retry:
  case Kind::KeepRunning:
  case Kind::Timeout:
  case Kind::Delay:
  case Kind::Recovery:
  case Kind::RoundRobin:
  case Kind::Persistent:
  case Kind::Pipeline:
  case Kind::Nonblocking:
  case Kind::PauseResume:
  case Kind::Own: return false;
  }
  return false;
}

bool maySkip(const Node& node) {
  return node.ports.contains("_skipIf") || node.ports.contains("_while") || maySkipInside(node);
}

Ends Traits::ends(const Node& node) const {
  auto ends = endsInside(node);
  if (node.ports.contains("_failureIf")) ends.failure = true;
  if (node.ports.contains("_successIf")) ends.success = true;
  return ends;
}

Ends Traits::endsInside(const Node& node) const {
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
  case Kind::ReactiveSequence:
  case Kind::Pipeline: return all(node.children);
  case Kind::Fallback:
  case Kind::ReactiveFallback:
  case Kind::RoundRobin: return any(node);
  case Kind::Parallel: return parallel(node);
  case Kind::ParallelAll: return parallelAll(node);
  case Kind::IfThenElse:
  case Kind::WhileDoElse:
  case Kind::Switch: return choice(node);
  case Kind::Inverter: return inverted(child());
  case Kind::ForceSuccess: return {isEnding(child()), false};
  case Kind::ForceFailure: return {false, isEnding(child())};
  case Kind::Repeat:
  case Kind::Retry:
  case Kind::KeepRunning: return loop(node);
  case Kind::Timeout: return {child().success, true};
  case Kind::Persistent: return {true, all(node.children).failure};
  case Kind::Nonblocking: return together(node);
  case Kind::PauseResume: return pauseResume(node);
  case Kind::Own: return {true, true};
  case Kind::Precondition:
  case Kind::Queue: return orElse(node);
  case Kind::TryCatch: return tryCatch(node);
  case Kind::Recovery:
  case Kind::RunOnce:
  case Kind::Rate:
  case Kind::Delay:
  case Kind::SubTree: return child();
  }
  return {};
}

Ends Traits::leafEnds(const Node& node) const {
  const auto& leaf = leaves.of(node.name, node.id);
  return {leaf.succeeds, leaf.fails};
}

Ends Traits::all(std::span<const Node> inOrder) const {
  Ends result{true, false};
  for (std::size_t i = 0; i < inOrder.size() && result.success; ++i) {
    const auto child = ends(inOrder[i]);
    result.failure = result.failure || child.failure;
    result.success = child.success || maySkip(inOrder[i]);
  }
  return result;
}

Ends Traits::any(const Node& node) const {
  Ends result{false, true};
  for (std::size_t i = 0; i < node.children.size() && result.failure; ++i) {
    const auto child = ends(node.children[i]);
    result.success = result.success || child.success;
    result.failure = child.failure || maySkip(node.children[i]);
  }
  return result;
}

/// All children run from the first tick on.
Ends Traits::together(const Node& node) const {
  Ends result{true, false};
  for (const auto& child : node.children) {
    const auto end = ends(child);
    result = {result.success && end.success, result.failure || end.failure};
  }
  return result;
}

Ends Traits::parallel(const Node& node) const {
  const auto thresholds = thresholdsOf(node).value_or(Thresholds{});
  std::int64_t succeeding = 0;
  std::int64_t failing = 0;
  for (const auto& child : node.children) {
    const auto end = ends(child);
    if (end.success) ++succeeding;
    if (end.failure) ++failing;
  }
  return {succeeding >= thresholds.successes, failing >= thresholds.failures};
}

Ends Traits::parallelAll(const Node& node) const {
  const auto needed = failuresOf(node).value_or(1);
  std::int64_t certain = 0;
  std::int64_t possible = 0;
  for (const auto& child : node.children) {
    const auto end = ends(child);
    if (!isEnding(end)) return {false, false};
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

Ends Traits::orElse(const Node& node) const {
  auto result = ends(node.children.front());
  if (node.kind == Kind::Queue) result.success = false; // then comes the next element
  result.success = result.success || otherwiseOf(node) == Otherwise::Success;
  result.failure = result.failure || otherwiseOf(node) == Otherwise::Failure;
  return result;
}

Ends Traits::tryCatch(const Node& node) const {
  const auto& last = node.children.back();
  const auto tried = all(std::span(node.children).first(node.children.size() - 1));
  return {tried.success, tried.failure && (isEnding(ends(last)) || maySkip(last))};
}

Ends Traits::pauseResume(const Node& node) const {
  const auto& resumed = node.children.front();
  auto result = ends(resumed);
  result.success = result.success || maySkip(resumed);
  for (const auto& paused : std::span(node.children).subspan(1))
    result.failure = result.failure || ends(paused).failure;
  return result;
}

bool Traits::isPure(const Node& node) const { return !hasPrecondition(node) && isPureInside(node); }

bool Traits::isPureInside(const Node& node) const {
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
  case Kind::Delay:
  case Kind::RunOnce:
  case Kind::Precondition:
  case Kind::Queue:
  case Kind::TryCatch:
  case Kind::Recovery:
  case Kind::RoundRobin:
  case Kind::Persistent:
  case Kind::Pipeline:
  case Kind::Nonblocking:
  case Kind::PauseResume:
  case Kind::Own:
  case Kind::Rate: return false;
  }
  return false;
}

Ends Traits::endsAtOnce(const Node& node) const {
  if (hasPrecondition(node)) return {};
  if (isPure(node)) return ends(node);
  if (node.kind == Kind::Action)
    return leaves.of(node.name, node.id).least == "0" ? leafEnds(node) : Ends{};
  if (node.kind == Kind::Sequence || node.kind == Kind::Fallback) return inOrderAtOnce(node);
  if (node.children.size() != 1) return {};
  const auto child = endsAtOnce(node.children.front());
  if (node.kind == Kind::SubTree) return child;
  if (node.kind == Kind::Inverter) return inverted(child);
  if (node.kind == Kind::ForceSuccess) return {isEnding(child), false};
  if (node.kind == Kind::ForceFailure) return {false, isEnding(child)};
  return {};
}

Ends Traits::inOrderAtOnce(const Node& node) const {
  const bool isSequence = node.kind == Kind::Sequence;
  bool goesOn = true;
  bool endsEarly = false;
  for (std::size_t i = 0; i < node.children.size() && goesOn; ++i) {
    const auto child = endsAtOnce(node.children[i]);
    endsEarly = endsEarly || (isSequence ? child.failure : child.success);
    goesOn = isSequence ? child.success : child.failure;
  }
  return isSequence ? Ends{goesOn, endsEarly} : Ends{endsEarly, goesOn};
}

bool Traits::isInstant(const Node& node) const {
  if (hasPrecondition(node)) return false;
  if (isPureInside(node)) return true;
  if (node.kind == Kind::Action) return leaves.of(node.name, node.id).isInstant();
  const bool isInOrder = node.kind == Kind::Sequence || node.kind == Kind::Fallback ||
                         node.kind == Kind::IfThenElse || node.kind == Kind::Inverter ||
                         node.kind == Kind::ForceSuccess || node.kind == Kind::ForceFailure;
  return isInOrder &&
         std::ranges::all_of(node.children, [&](const Node& child) { return isInstant(child); });
}

bool Traits::hasInstantAction(const Node& node) const {
  if (node.kind == Kind::Action) return leaves.of(node.name, node.id).isInstant();
  return std::ranges::any_of(node.children,
                             [&](const Node& child) { return hasInstantAction(child); });
}

bool Traits::mayEndAtOnce(const Node& node) const {
  if (isPure(node) || hasPrecondition(node) || maySkip(node)) return true;
  if (node.kind == Kind::RunOnce || node.kind == Kind::Precondition || node.kind == Kind::Queue ||
      node.kind == Kind::Persistent || node.kind == Kind::Own)
    return true;
  if (node.kind == Kind::Action) return leaves.of(node.name, node.id).isInstant();
  return std::ranges::any_of(node.children, [&](const Node& child) { return mayEndAtOnce(child); });
}

} // namespace proskill::bridge::bt
