#include "tests/bridge/ticker.h"

#include "bridge/bt/tree/traits.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

namespace proskill::test {

namespace {

using bridge::bt::Kind;
using bridge::bt::Node;

enum class Status : std::uint8_t { Running, Success, Failure };

/// What a node remembers from one tick to the next.
struct Memory {
  bool running = false;
  int at = 0;             ///< the current child, the number of rounds, the phase of a delay
  std::uint32_t done = 0; ///< children of a parallel node that have ended
  std::uint32_t good = 0; ///< with a success
  auto operator<=>(const Memory&) const = default;
};

using State = std::vector<Memory>;

/// The choices of one tick, enumerated like the digits of a number.
class Choices {
public:
  std::size_t below(std::size_t count) {
    if (position == digits.size()) digits.push_back({0, count});
    return digits[position++].first;
  }
  /// Turns to the next sequence of choices; false after the last one.
  bool next() {
    position = 0;
    while (!digits.empty() && ++digits.back().first == digits.back().second) digits.pop_back();
    return !digits.empty();
  }

private:
  std::vector<std::pair<std::size_t, std::size_t>> digits;
  std::size_t position = 0;
};

class Ticker {
public:
  Ticker(const Node& tree, const bridge::bt::Leaves& allowed) : leaves(allowed) { number(tree); }

  std::optional<Observed> explore(std::size_t limit) {
    std::set<State> known{State(nodes.size())};
    std::deque<State> waiting{*known.begin()};
    while (!waiting.empty()) {
      const auto from = waiting.front();
      waiting.pop_front();
      do {
        state = from;
        const auto result = tick(0);
        if (result == Status::Success) seen.success = true;
        if (result == Status::Failure) seen.failure = true;
        if (result == Status::Running && known.insert(state).second) waiting.push_back(state);
      } while (choices.next());
      if (known.size() > limit) return std::nullopt;
    }
    return seen;
  }

private:
  struct Numbered {
    const Node* node;
    std::vector<std::size_t> children;
  };

  std::size_t number(const Node& node) {
    const auto index = nodes.size();
    nodes.push_back({&node, {}});
    for (const auto& child : node.children) {
      const auto at = number(child);
      nodes[index].children.push_back(at);
    }
    return index;
  }

  Status tick(std::size_t n) {
    const bool wasRunning = state[n].running;
    state[n].running = true;
    const auto result = step(n, wasRunning);
    if (result != Status::Running) halt(n);
    return result;
  }

  /// Children first: they may be running.
  void halt(std::size_t n) {
    for (const auto child : nodes[n].children)
      if (state[child].running) halt(child);
    const int kept = nodes[n].node->kind == Kind::SequenceWithMemory ? state[n].at : 0;
    state[n] = {.at = kept};
  }

  Status step(std::size_t n, bool wasRunning) {
    const auto& node = *nodes[n].node;
    const auto& kids = nodes[n].children;
    switch (node.kind) {
    case Kind::Action: return action(n, wasRunning);
    case Kind::Condition: return choices.below(2) == 0 ? Status::Success : Status::Failure;
    case Kind::Script:
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
    case Kind::SubTree: return tick(kids[0]);
    }
    return Status::Failure;
  }

  Status action(std::size_t n, bool wasRunning) {
    const auto& node = *nodes[n].node;
    if (!wasRunning) start(n);
    const auto& leaf = leaves.of(node);
    std::vector<Status> results{Status::Running};
    if (leaf.succeeds) results.push_back(Status::Success);
    if (leaf.fails) results.push_back(Status::Failure);
    return results[choices.below(results.size())];
  }

  void start(std::size_t n) {
    seen.started.insert(nodes[n].node->name);
    for (std::size_t other = 0; other < nodes.size(); ++other)
      if (other != n && nodes[other].node->kind == Kind::Action && state[other].running)
        seen.together.insert(std::minmax(nodes[other].node->name, nodes[n].node->name));
  }

  /// Whether a time is over that has not passed in the tick that starts it.
  bool pause(std::size_t /*n*/, bool wasRunning) { return wasRunning && choices.below(2) == 1; }

  Status inOrder(std::size_t n, Status goOn, bool forgets) {
    const auto& kids = nodes[n].children;
    while (state[n].at < static_cast<int>(kids.size())) {
      const auto result = tick(kids[static_cast<std::size_t>(state[n].at)]);
      if (result == Status::Running) return result;
      if (result != goOn) {
        if (forgets) state[n].at = 0;
        return result;
      }
      ++state[n].at;
    }
    state[n].at = 0;
    return goOn;
  }

  Status reactive(std::size_t n, Status goOn) {
    for (const auto child : nodes[n].children) {
      const auto result = tick(child);
      if (result == Status::Running) haltOthers(n, child);
      if (result != goOn) return result;
    }
    return goOn;
  }

  void haltOthers(std::size_t n, std::size_t kept) {
    for (const auto child : nodes[n].children)
      if (child != kept) halt(child);
  }

  Status parallel(std::size_t n) {
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

  void tickOnce(std::size_t n, std::size_t i) {
    if ((state[n].done >> i & 1U) != 0) return;
    const auto result = tick(nodes[n].children[i]);
    if (result != Status::Running) state[n].done |= 1U << i;
    if (result == Status::Success) state[n].good |= 1U << i;
  }

  Status parallelAll(std::size_t n) {
    const auto count = nodes[n].children.size();
    for (std::size_t i = 0; i < count; ++i) tickOnce(n, i);
    if (std::popcount(state[n].done) < static_cast<int>(count)) return Status::Running;
    const int bad = std::popcount(state[n].done & ~state[n].good);
    const int allowed = std::stoi(nodes[n].node->port("max_failures", "1"));
    return bad >= allowed ? Status::Failure : Status::Success;
  }

  Status ifThenElse(std::size_t n) {
    const auto& kids = nodes[n].children;
    if (state[n].at == 0) {
      const auto result = tick(kids[0]);
      if (result == Status::Running) return result;
      state[n].at = result == Status::Success ? 1 : 2;
    }
    const auto at = static_cast<std::size_t>(state[n].at);
    return at < kids.size() ? tick(kids[at]) : Status::Failure;
  }

  Status whileDoElse(std::size_t n) {
    const auto& kids = nodes[n].children;
    const auto result = tick(kids[0]);
    if (result == Status::Running) return result;
    const std::size_t chosen = result == Status::Success ? 1 : 2;
    if (kids.size() > 2) halt(kids[3 - chosen]);
    return chosen < kids.size() ? tick(kids[chosen]) : Status::Failure;
  }

  Status choice(std::size_t n) {
    const auto& kids = nodes[n].children;
    const auto child = kids[choices.below(kids.size())];
    haltOthers(n, child);
    return tick(child);
  }

  Status rounds(std::size_t n, Status again, const char* port) {
    const auto child = nodes[n].children[0];
    const int limit = std::stoi(nodes[n].node->port(port));
    for (;;) {
      const bool wasRunning = state[child].running;
      const auto result = tick(child);
      if (result != again) return result;
      if (limit != -1 && ++state[n].at >= limit) return again;
      if (!wasRunning) return Status::Running; // it asks for another tick at once
    }
  }

  Status timeout(std::size_t n) {
    const auto child = nodes[n].children[0];
    if (lasts(child) && choices.below(2) == 1) return Status::Failure;
    return tick(child);
  }

  /// Whether it can run for long. \pre it contains no fixed times
  bool lasts(std::size_t n) const {
    const auto& node = *nodes[n].node;
    const bool endless = node.kind == Kind::KeepRunning || bridge::bt::roundsOf(node) == -1;
    if (node.kind == Kind::Action || endless) return state[n].running;
    return std::ranges::any_of(nodes[n].children, [&](auto child) { return lasts(child); });
  }

  static Status inverted(Status result) {
    if (result == Status::Running) return result;
    return result == Status::Success ? Status::Failure : Status::Success;
  }

  /// `to` in place of any end, or of one.
  static Status forced(Status result, Status to, std::optional<Status> only = {}) {
    if (result == Status::Running || (only && result != *only)) return result;
    return to;
  }

  std::vector<Numbered> nodes;
  const bridge::bt::Leaves& leaves;
  State state;
  Choices choices;
  Observed seen;
};

} // namespace

bool covers(const Observed& whole, const Observed& part) {
  return (whole.success || !part.success) && (whole.failure || !part.failure) &&
         std::ranges::includes(whole.started, part.started) &&
         std::ranges::includes(whole.together, part.together);
}

std::string inWords(const Observed& observed) {
  auto text =
      fmt::format("{}{}", observed.success ? "success " : "", observed.failure ? "failure" : "");
  text += "\n  started:";
  for (const auto& name : observed.started) text += " " + name;
  text += "\n  together:";
  for (const auto& [a, b] : observed.together) text += " " + a + "&" + b;
  return text;
}

std::optional<Observed> observe(const bridge::bt::Node& tree, const bridge::bt::Leaves& leaves,
                                std::size_t limit) {
  return Ticker(tree, leaves).explore(limit);
}

} // namespace proskill::test
