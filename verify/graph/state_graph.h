#pragma once

#include "verify/verify.h"

#include <utility>

namespace proskill::verify {

/// The kind of states of a graph.
enum class GraphKind : std::uint8_t {
  Classes, ///< state classes, as `tina -W` and `sift -W` build
  /// Discrete states that are reachable in time; classes with the same marking are one state.
  Markings,
  Untimed, ///< discrete states reachable without regard to time, as `tina -R` builds
};

/// A state graph whose parts have the names that frac and the Tina tools give them. State 0 is the
/// initial one; the others are numbered breadth first. The same model always gives the same graph.
struct StateGraph {
  struct Edge {
    std::uint32_t source = 0;
    std::uint32_t label = 0; ///< index in `labels`
    std::uint32_t target = 0;
  };
  /// Properties of a marking as indices in `properties`, each with its number: 1 for a place, the
  /// value for a variable. Zeros are omitted.
  using Marking = std::vector<std::pair<std::uint32_t, std::int64_t>>;

  std::vector<std::string> labels;
  std::vector<std::string> properties;
  std::vector<Edge> edges;              ///< by source
  std::vector<std::uint32_t> markingOf; ///< by state: index in `markings`
  std::vector<Marking> markings;        ///< in the order in which they are reached
  Exploration counts;                   ///< the numbers of classes that sift prints
};

/// The whole graph, without reductions. If a limit was reached, `counts.complete` is false and the
/// graph has neither states nor edges.
[[nodiscard]] std::expected<StateGraph, Unsupported>
stateGraph(const fiacre::Program& program, GraphKind kind, const Options& options = {});

} // namespace proskill::verify
