#pragma once

#include "tests/meaning/steps.h"

#include <set>

namespace proskill::meaning {

struct Edge {
  std::size_t target = 0;
  std::vector<Fact> facts;
  bool due = false; ///< it has to happen now
};

struct Node {
  Situation situation;
  std::vector<Edge> edges;
  std::optional<std::size_t> later; ///< after a little time
  bool timePasses = false;          ///< by however little
};

/// All runs of a program. Times are told apart as far as bounds can tell them apart: whole units,
/// and the order of the fractions. Alur and Dill, "A theory of timed automata" (TCS 1994).
class Runs {
public:
  /// Stops when there are `limit` nodes.
  Runs(const Script& script, std::size_t limit);

  [[nodiscard]] bool complete() const { return finished; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return all; }
  /// What happens in some run.
  [[nodiscard]] const std::set<Fact>& facts() const { return found; }
  [[nodiscard]] bool canStop() const;
  /// In every situation time can go on, now or after some steps that have to happen.
  [[nodiscard]] bool timeCanGoOn() const;

private:
  void expand(std::size_t node);
  std::size_t add(Situation situation);
  void letTimePass(std::size_t node, const std::vector<Step>& steps);
  void noteState(const Situation& situation);
  [[nodiscard]] Situation inOrder(Situation situation) const;

  const Script& script;
  std::int64_t longest = 0; ///< the largest bound
  std::vector<Node> all;
  std::map<Situation, std::size_t> known;
  std::set<Fact> found;
  bool finished = false;
};

/// Whether a step may happen at these ages.
[[nodiscard]] bool isDue(const When& when, const std::vector<Age>& ages);

} // namespace proskill::meaning
