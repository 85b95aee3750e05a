#pragma once

#include "tests/meaning/steps.h"

#include <set>

namespace proskill::meaning {

struct Edge {
  std::size_t target = 0;
  std::vector<Fact> facts;
  bool due = false; ///< it is urgent
};

struct Node {
  Situation situation;
  std::vector<Edge> edges;
  std::optional<std::size_t> later; ///< after a little time
  bool timePasses = false;          ///< after arbitrarily little time
  std::size_t restarted = 0;        ///< the same moment with the watch at 0, if there is one
};

/// All runs of a program, by regions: ages are distinguished by integers up to the bounds, and by
/// the order of their fractions. Alur and Dill, "A theory of timed automata" (TCS 1994).
class Runs {
public:
  /// Stops at `limit` nodes. \param watch adds an age that always runs, as `watch()` says,
  /// distinguished up to this bound
  Runs(const Script& script, std::size_t limit, std::optional<std::int64_t> watch = {});

  [[nodiscard]] bool complete() const { return finished; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return all; }
  /// Time since the watch was at 0. \pre there is one
  [[nodiscard]] static const Age& watch(const Node& node) { return node.situation.ages.back(); }
  /// The initial nodes.
  [[nodiscard]] const std::set<std::size_t>& starts() const { return begins; }
  /// Facts of some run.
  [[nodiscard]] const std::set<Fact>& facts() const { return found; }
  [[nodiscard]] bool canStop() const;
  /// Whether time can pass in every situation, now or after some urgent steps.
  [[nodiscard]] bool timeCanGoOn() const;

private:
  void expand(std::size_t node);
  std::size_t add(Situation situation);
  void letTimePass(std::size_t node, const std::vector<Step>& steps);
  void noteState(const Situation& situation);
  [[nodiscard]] Situation inOrder(Situation situation) const;

  const Script& script;
  std::int64_t longest = 0; ///< the largest bound
  bool hasWatch = false;
  std::vector<Node> all;
  std::map<Situation, std::size_t> known;
  std::set<std::size_t> begins;
  std::set<Fact> found;
  bool finished = false;
};

/// Compares an age with a bound: `reaches` is true from the first moment not before it, `isPast`
/// from the first one after it.
[[nodiscard]] bool reaches(const Age& age, std::int64_t bound, bool open);
[[nodiscard]] bool isPast(const Age& age, std::int64_t bound, bool open);

/// Whether a step may happen at these ages.
[[nodiscard]] bool isDue(const When& when, const std::vector<Age>& ages);

/// Whether its deadline has passed.
[[nodiscard]] bool isLate(const When& when, const std::vector<Age>& ages);

} // namespace proskill::meaning
