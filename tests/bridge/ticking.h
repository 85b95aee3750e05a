#pragma once

#include "tests/bridge/ticker.h"

#include <map>

namespace proskill::test {

using bridge::bt::Kind;
using bridge::bt::Node;

enum class Status : std::uint8_t { Running, Success, Failure, Skipped };

/// What a node remembers from one tick to the next.
struct Memory {
  bool running = false;
  int at = 0;             ///< the current child, the number of rounds, the phase of a delay
  std::uint32_t done = 0; ///< children of a parallel node that have ended
  std::uint32_t good = 0; ///< with a success; of a sequence: how many were skipped
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

/// Ticks a tree in all ways. The nodes that most trees have are in ticker.cpp, the others in
/// ticker_rare.cpp.
class Ticker {
public:
  Ticker(const Node& tree, const bridge::Leaves& allowed) : leaves(allowed) {
    number(tree);
    fresh.resize(nodes.size() + entries.size());
  }
  std::optional<Observed> explore(std::size_t limit);

private:
  struct Numbered {
    const Node* node;
    std::vector<std::size_t> children;
  };

  std::size_t number(const Node& node) {
    const auto index = nodes.size();
    nodes.push_back({&node, {}});
    if (const auto code = scriptOf(node); code.starts_with('@'))
      entries.emplace(code.substr(0, code.find(' ')), entries.size());
    for (const auto& child : node.children) {
      const auto at = number(child);
      nodes[index].children.push_back(at);
    }
    return index;
  }
  static std::string scriptOf(const Node& node) { return node.port("code"); }
  /// The value of the entry `@name` that a script or a script's condition is about.
  int& entryOf(std::size_t n);
  /// Executes `@name := 1; …`, as emit writes it.
  Status script(std::size_t n);
  /// Decides `@name == 1`; any other script may have any result.
  Status scriptCondition(std::size_t n);
  /// Whether a script of a node has a result; without the script, it has not.
  bool holds(std::size_t n, const char* script);
  /// What scripts decide in place of a tick.
  std::optional<Status> decided(std::size_t n);
  Status tick(std::size_t n);
  /// Children first: they may be running.
  void halt(std::size_t n);
  Status step(std::size_t n, bool wasRunning);
  Status action(std::size_t n, bool wasRunning);
  void start(std::size_t n);
  /// Whether a time is over that has not passed in the tick that starts it.
  bool pause(std::size_t /*n*/, bool wasRunning);
  Status inOrder(std::size_t n, Status goOn, bool forgets);
  /// It goes on where it was halted, and begins again after a failure.
  Status persistent(std::size_t n);
  /// Children that have succeeded are started again.
  Status nonblocking(std::size_t n);
  /// Its phase: 0 resumed, 1 on pause, 2 paused, 3 on resume; children are in another order.
  Status pauseResume(std::size_t n);
  void switchTo(std::size_t n, int phase);
  /// Each child is left alone, ticked, or halted; then any result.
  Status own(std::size_t n);
  Status runOnce(std::size_t n);
  Status precondition(std::size_t n);
  static Status named(const std::string& status);
  Status queue(std::size_t n);
  Status tryCatch(std::size_t n);
  Status reactive(std::size_t n, Status goOn);
  void haltOthers(std::size_t n, std::size_t kept);
  Status parallel(std::size_t n);
  void tickOnce(std::size_t n, std::size_t i);
  Status parallelAll(std::size_t n);
  Status ifThenElse(std::size_t n);
  Status whileDoElse(std::size_t n);
  Status choice(std::size_t n);
  Status rounds(std::size_t n, Status again, const char* port);
  Status timeout(std::size_t n);
  Status recovery(std::size_t n);
  /// Where it begins is kept after a success only.
  Status roundRobin(std::size_t n);
  Status pipeline(std::size_t n);
  /// Whether it can run for long. \pre it contains no fixed times
  bool lasts(std::size_t n) const;
  static Status inverted(Status result);
  /// `to` in place of any end, or of one.
  static Status forced(Status result, Status to, std::optional<Status> only = {});
  std::vector<Numbered> nodes;
  std::map<std::string, std::size_t> entries; ///< of the blackboard: kept after the nodes' memory
  State fresh;
  const bridge::Leaves& leaves;
  State state;
  Choices choices;
  Observed seen;
};

} // namespace proskill::test
