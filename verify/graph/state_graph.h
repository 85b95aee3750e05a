#pragma once

#include "verify/verify.h"

#include <utility>

namespace proskill::verify {

/// What the states of a graph are.
enum class GraphKind : std::uint8_t {
  Classes,  ///< state classes: what `tina -W` and `sift -W` build
  Markings, ///< discrete states that time allows: classes of the same marking are one
  Untimed,  ///< discrete states as if there were no time: what `tina -R` builds
};

/// A state graph with the names that frac and the Tina tools give to its parts. State 0 is the
/// initial one; the others are numbered breadth first. The same model has the same graph, always.
struct StateGraph {
  struct Edge {
    std::uint32_t source = 0;
    std::uint32_t label = 0; ///< in `labels`
    std::uint32_t target = 0;
  };
  /// What a marking has, by its place in `properties`, and how often: a place once, a variable as
  /// its value says. What is 0 is left out.
  using Marking = std::vector<std::pair<std::uint32_t, std::int64_t>>;

  std::vector<std::string> labels;
  std::vector<std::string> properties;
  std::vector<Edge> edges;              ///< by source
  std::vector<std::uint32_t> markingOf; ///< by state
  std::vector<Marking> markings;        ///< in the order in which they are reached
  Exploration counts;                   ///< what sift counts, of the classes that were explored
};

/// The whole graph, with nothing reduced. Where a limit was met, `counts.complete` is false and the
/// graph has neither states nor edges.
[[nodiscard]] std::expected<StateGraph, Unsupported>
stateGraph(const fiacre::Program& program, GraphKind kind, const Options& options = {});

} // namespace proskill::verify
