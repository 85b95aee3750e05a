#include "tests/bridge/ticker.h"

#include "tests/bridge/ticking.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

namespace proskill::test {

std::optional<Observed> Ticker::explore(std::size_t limit) {
  std::set<State> known{fresh};
  std::deque<State> waiting{*known.begin()};
  std::size_t ticks = 0;
  while (!waiting.empty()) {
    const auto from = waiting.front();
    waiting.pop_front();
    do {
      state = from;
      const auto result = tick(0);
      if (result == Status::Success) seen.success = true;
      if (result == Status::Failure) seen.failure = true;
      if (result == Status::Skipped) seen.skipped = true;
      if (result == Status::Running && known.insert(state).second) waiting.push_back(state);
      if (++ticks > 100 * limit) return std::nullopt;
    } while (choices.next());
    if (known.size() > limit) return std::nullopt;
  }
  return seen;
}

bool Ticker::holds(std::size_t n, const char* script) {
  return nodes[n].node->ports.contains(script) && choices.below(2) == 1;
}

std::optional<Status> Ticker::decided(std::size_t n) {
  if (state[n].running) return holds(n, "_while") ? std::optional(Status::Skipped) : std::nullopt;
  if (holds(n, "_failureIf")) return Status::Failure;
  if (holds(n, "_successIf")) return Status::Success;
  if (holds(n, "_skipIf") || holds(n, "_while")) return Status::Skipped;
  return {};
}

Status Ticker::tick(std::size_t n) {
  if (const auto result = decided(n)) {
    if (state[n].running) halt(n);
    return *result;
  }
  const bool wasRunning = state[n].running;
  state[n].running = true;
  const auto result = step(n, wasRunning);
  if (result != Status::Running) halt(n);
  return result;
}

void Ticker::halt(std::size_t n) {
  for (const auto child : nodes[n].children)
    if (state[child].running) halt(child);
  const auto kind = nodes[n].node->kind;
  const bool remembers =
      kind == Kind::SequenceWithMemory || kind == Kind::RunOnce || kind == Kind::Persistent;
  state[n] = {.at = remembers ? state[n].at : 0};
}

Status Ticker::step(std::size_t n, bool wasRunning) {
  const auto& node = *nodes[n].node;
  const auto& kids = nodes[n].children;
  switch (node.kind) {
  case Kind::Action: return action(n, wasRunning);
  case Kind::Condition: return scriptCondition(n);
  case Kind::Script: return script(n);
  case Kind::AlwaysSuccess: return Status::Success;
  case Kind::AlwaysFailure: return Status::Failure;
  case Kind::Sleep: return pause(n, wasRunning) ? Status::Success : Status::Running;
  case Kind::Delay:
    if (state[n].at == 0 && !pause(n, wasRunning)) return Status::Running;
    state[n].at = 1;
    return tick(kids[0]);
  case Kind::Sequence: return inOrder(n, Status::Success, true);
  case Kind::Fallback: return inOrder(n, Status::Failure, true);
  case Kind::SequenceWithMemory: return inOrder(n, Status::Success, false);
  case Kind::Persistent: return persistent(n);
  case Kind::Nonblocking: return nonblocking(n);
  case Kind::PauseResume: return pauseResume(n);
  case Kind::Own: return own(n);
  case Kind::RunOnce: return runOnce(n);
  case Kind::Precondition: return precondition(n);
  case Kind::Queue: return queue(n);
  case Kind::TryCatch: return tryCatch(n);
  case Kind::ReactiveSequence: return reactive(n, Status::Success);
  case Kind::ReactiveFallback: return reactive(n, Status::Failure);
  case Kind::Parallel: return parallel(n);
  case Kind::ParallelAll: return parallelAll(n);
  case Kind::IfThenElse: return ifThenElse(n);
  case Kind::WhileDoElse: return whileDoElse(n);
  case Kind::Switch: return choice(n);
  case Kind::Inverter: return inverted(tick(kids[0]));
  case Kind::ForceSuccess: return forced(tick(kids[0]), Status::Success);
  case Kind::ForceFailure: return forced(tick(kids[0]), Status::Failure);
  case Kind::Repeat: return rounds(n, Status::Success, "num_cycles");
  case Kind::Retry: return rounds(n, Status::Failure, "num_attempts");
  case Kind::KeepRunning: return forced(tick(kids[0]), Status::Running, Status::Success);
  case Kind::Timeout: return timeout(n);
  case Kind::Recovery: return recovery(n);
  case Kind::RoundRobin: return roundRobin(n);
  case Kind::Pipeline: return pipeline(n);
  case Kind::Rate:
    if (choices.below(2) == 1) return Status::Running;
    return tick(kids[0]);
  case Kind::SubTree: return tick(kids[0]);
  }
  return Status::Failure;
}

Status Ticker::action(std::size_t n, bool wasRunning) {
  const auto& node = *nodes[n].node;
  if (!wasRunning) start(n);
  const auto& leaf = leaves.of(node.name, node.id);
  std::vector<Status> results;
  if (!leaf.isInstant()) results.push_back(Status::Running);
  if (leaf.succeeds) results.push_back(Status::Success);
  if (leaf.fails) results.push_back(Status::Failure);
  return results[choices.below(results.size())];
}

void Ticker::start(std::size_t n) {
  seen.started.insert(nodes[n].node->name);
  for (std::size_t other = 0; other < nodes.size(); ++other)
    if (other != n && nodes[other].node->kind == Kind::Action && state[other].running)
      seen.together.insert(std::minmax(nodes[other].node->name, nodes[n].node->name));
}

bool Ticker::pause(std::size_t /*n*/, bool wasRunning) {
  return wasRunning && choices.below(2) == 1;
}

Status Ticker::inOrder(std::size_t n, Status goOn, bool forgets) {
  const auto& kids = nodes[n].children;
  while (state[n].at < static_cast<int>(kids.size())) {
    const auto result = tick(kids[static_cast<std::size_t>(state[n].at)]);
    if (result == Status::Running) return result;
    if (result != goOn && result != Status::Skipped) {
      if (forgets) state[n].at = 0;
      return result;
    }
    if (result == Status::Skipped) ++state[n].good;
    ++state[n].at;
  }
  state[n].at = 0;
  return state[n].good == kids.size() ? Status::Skipped : goOn;
}

Status Ticker::reactive(std::size_t n, Status goOn) {
  bool ran = false;
  for (const auto child : nodes[n].children) {
    const auto result = tick(child);
    if (result == Status::Running) haltOthers(n, child);
    if (result != goOn && result != Status::Skipped) return result;
    ran = ran || result == goOn;
  }
  return ran ? goOn : Status::Skipped;
}

void Ticker::haltOthers(std::size_t n, std::size_t kept) {
  for (const auto child : nodes[n].children)
    if (child != kept) halt(child);
}

Status Ticker::parallel(std::size_t n) {
  const auto& kids = nodes[n].children;
  const auto count = static_cast<int>(kids.size());
  const auto threshold = [&](const char* port, const char* otherwise) {
    const int number = std::stoi(nodes[n].node->port(port, otherwise));
    return number < 0 ? number + count + 1 : number;
  };
  const int successes = threshold("success_count", "-1");
  const int failures = threshold("failure_count", "1");
  for (std::size_t i = 0; i < kids.size(); ++i) {
    tickOnce(n, i);
    const int good = std::popcount(state[n].good);
    const int bad = std::popcount(state[n].done) - good;
    if (good >= successes) return Status::Success;
    if (count - bad < successes || bad == failures) return Status::Failure;
  }
  return Status::Running;
}

void Ticker::tickOnce(std::size_t n, std::size_t i) {
  if ((state[n].done >> i & 1U) != 0) return;
  const auto result = tick(nodes[n].children[i]);
  if (result != Status::Running) state[n].done |= 1U << i;
  if (result == Status::Success) state[n].good |= 1U << i;
}

Status Ticker::parallelAll(std::size_t n) {
  const auto count = nodes[n].children.size();
  for (std::size_t i = 0; i < count; ++i) tickOnce(n, i);
  if (std::popcount(state[n].done) < static_cast<int>(count)) return Status::Running;
  const int bad = std::popcount(state[n].done & ~state[n].good);
  const int allowed = std::stoi(nodes[n].node->port("max_failures", "1"));
  return bad >= allowed ? Status::Failure : Status::Success;
}

Status Ticker::ifThenElse(std::size_t n) {
  const auto& kids = nodes[n].children;
  if (state[n].at == 0) {
    const auto result = tick(kids[0]);
    if (result == Status::Running) return result;
    state[n].at = result == Status::Success ? 1 : 2;
  }
  const auto at = static_cast<std::size_t>(state[n].at);
  return at < kids.size() ? tick(kids[at]) : Status::Failure;
}

Status Ticker::whileDoElse(std::size_t n) {
  const auto& kids = nodes[n].children;
  const auto result = tick(kids[0]);
  if (result == Status::Running) return result;
  const std::size_t chosen = result == Status::Success ? 1 : 2;
  if (kids.size() > 2) halt(kids[3 - chosen]);
  return chosen < kids.size() ? tick(kids[chosen]) : Status::Failure;
}

Status Ticker::choice(std::size_t n) {
  const auto& kids = nodes[n].children;
  const auto child = kids[choices.below(kids.size())];
  haltOthers(n, child);
  return tick(child);
}

Status Ticker::inverted(Status result) {
  if (result == Status::Running || result == Status::Skipped) return result;
  return result == Status::Success ? Status::Failure : Status::Success;
}

Status Ticker::forced(Status result, Status to, std::optional<Status> only) {
  if (result == Status::Running || result == Status::Skipped || (only && result != *only))
    return result;
  return to;
}

bool covers(const Observed& whole, const Observed& part) {
  return (whole.success || !part.success) && (whole.failure || !part.failure) &&
         (whole.skipped || !part.skipped) && std::ranges::includes(whole.started, part.started) &&
         std::ranges::includes(whole.together, part.together);
}

std::string inWords(const Observed& observed) {
  auto text = fmt::format("{}{}{}", observed.success ? "success " : "",
                          observed.failure ? "failure " : "", observed.skipped ? "skipped" : "");
  text += "\n  started:";
  for (const auto& name : observed.started) text += " " + name;
  text += "\n  together:";
  for (const auto& [a, b] : observed.together) text += " " + a + "&" + b;
  return text;
}

std::optional<Observed> observe(const bridge::bt::Node& tree, const bridge::Leaves& leaves,
                                std::size_t limit) {
  return Ticker(tree, leaves).explore(limit);
}

} // namespace proskill::test
