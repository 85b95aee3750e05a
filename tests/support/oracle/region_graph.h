#pragma once

#include "tests/support/oracle/interpreter.h"

#include <compare>
#include <set>
#include <string>

namespace proskill::oracle {

/// How old a transition is, up to the equivalence of Alur and Dill, "A theory of timed automata"
/// (TCS 1994): the whole part exactly, the fraction only by its order among the fractions of all
/// clocks. Rank 0 is no fraction.
///
/// A grid of fixed step cannot be exact for strict bounds: a run may halve the gap between two
/// fractions again and again. Ranks are spread anew after each step, so that there is always room
/// between two of them; this is exact, and with constants of at most three units as small as a
/// grid.
struct Age {
  ClockId clock = 0;
  std::int64_t whole = 0;
  std::uint32_t rank = 0;
  bool beyond = false; ///< past the last bound: how far does not matter, whole and rank are 0
  friend auto operator<=>(const Age&, const Age&) = default;
};

/// A clock of the judge's own, see RegionGraph.
inline constexpr ClockId kWatch = SIZE_MAX;

using Region = std::vector<Age>; ///< by clock, those with bounds that matter alone

/// A discrete state with all that follows from it.
struct DiscreteState {
  Store store;
  std::vector<Firing> firings;
  std::map<ClockId, fiacre::Interval> clocks; ///< of the timed transitions
  bool urgent = false;                        ///< time cannot pass: something has to happen now
};

struct Edge {
  std::size_t firing = 0; ///< of the discrete state
  std::size_t target = 0; ///< node
  bool due = false;       ///< time waits for it, or for one that it goes before
};

struct Node {
  std::size_t discrete = 0;
  Region region;
  std::vector<Edge> edges;
  std::optional<std::size_t> later; ///< the next region, where time may reach it
  bool timePasses = false;          ///< by however little
  std::size_t restarted = 0;        ///< the same with the watch at 0, where there is one
};

/// The graph of regions of a model: every discrete state, and every way in which its clocks can
/// stand to each other.
class RegionGraph {
public:
  /// Explores until the end or until there are `limit` nodes. \throw ModelError
  /// \param watch has the graph a clock that no step touches and that may start anew at any moment,
  /// told apart up to this many units
  RegionGraph(const Interpreter& model, std::size_t limit, std::optional<std::int64_t> watch = {});

  [[nodiscard]] bool complete() const { return finished; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return all; }
  [[nodiscard]] const DiscreteState& discrete(std::size_t index) const { return states[index]; }
  [[nodiscard]] std::size_t discreteCount() const { return states.size(); }

private:
  void expand(std::size_t node);
  std::size_t addDiscrete(const Store& store);
  std::size_t addNode(std::size_t discrete, Region region);
  void letTimePass(std::size_t node);
  [[nodiscard]] Region after(const Node& node, const Firing& firing,
                             const DiscreteState& target) const;

  const Interpreter& model;
  std::optional<std::int64_t> watch;
  std::vector<DiscreteState> states;
  std::map<Store, std::size_t> stateIndex;
  std::vector<Node> all;
  std::map<std::pair<std::size_t, Region>, std::size_t> nodeIndex;
  bool finished = false;
};

} // namespace proskill::oracle
