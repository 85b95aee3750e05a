#pragma once

#include "tests/support/oracle/interpreter.h"

#include <compare>
#include <set>
#include <string>

namespace proskill::oracle {

/// Age of a transition, up to the equivalence of Alur and Dill, "A theory of timed automata" (TCS
/// 1994): the exact integer part, and the rank of the fraction among all clocks. Rank 0 means no
/// fraction.
///  A grid of fixed step cannot be exact for strict bounds, since a run may halve the gap between
///  two fractions again and again. Ranks are renumbered after each step, so that there is always
///  space between two of them. This is exact, and for constants up to three units as small as a
///  grid.
struct Age {
  ClockId clock = 0;
  std::int64_t whole = 0;
  std::uint32_t rank = 0;
  bool beyond = false; ///< beyond the last bound: integer part and rank are 0
  friend auto operator<=>(const Age&, const Age&) = default;
};

/// An additional clock, see RegionGraph.
inline constexpr ClockId kWatch = SIZE_MAX;

using Region = std::vector<Age>; ///< by clock; only those with relevant bounds

/// A discrete state with derived data.
struct DiscreteState {
  Store store;
  std::vector<Firing> firings;
  std::map<ClockId, fiacre::Interval> clocks; ///< of the timed transitions
  bool urgent = false;                        ///< time cannot pass: a step is urgent
};

struct Edge {
  std::size_t firing = 0; ///< of the discrete state
  std::size_t target = 0; ///< node
  bool due = false;       ///< time waits for it, or for one over which it has priority
};

struct Node {
  std::size_t discrete = 0;
  Region region;
  std::vector<Edge> edges;
  std::optional<std::size_t> later; ///< the next region, if time may reach it
  bool timePasses = false;          ///< by arbitrarily little time
  std::size_t restarted = 0;        ///< the same with the watch at 0, if there is one
};

/// The region graph of a model: all discrete states with all regions of their clocks.
class RegionGraph {
public:
  /// Explores to the end or to `limit` nodes. \throw ModelError
  /// \param watch adds a clock that steps do not reset and that may be reset at any moment,
  /// distinguished up to this many units
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
