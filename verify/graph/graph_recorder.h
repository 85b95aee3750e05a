#pragma once

#include "verify/graph/state_graph.h"
#include "verify/space/state_tree.h"
#include "verify/state/run.h"

#include <unordered_map>

namespace proskill::verify {

/// Records the edges of a class graph during its exploration, and builds the graph from them.
class GraphRecorder {
public:
  GraphRecorder(const System& of, std::string mainComponent, GraphKind graphKind)
      : system(of), main(std::move(mainComponent)), kind(graphKind) {}

  /// A state class: its marking and its firing domain.
  struct Class {
    std::uint32_t marking = 0;
    ZoneId domain = 0;
  };
  /// The label of the transition that was just fired, as an argument of `edge`.
  [[nodiscard]] std::uint32_t label(TransitionId transition, const StepLog& log);
  void edge(Class from, std::uint32_t label, Class to);
  [[nodiscard]] std::uint64_t bytes() const;

  /// The graph of all recorded edges. `markings` are the packed markings to which the classes
  /// refer.
  [[nodiscard]] StateGraph graph(Class initial, const StateTree& markings) const;

private:
  [[nodiscard]] std::uint32_t node(Class of);
  void addProperties(StateGraph& graph, const std::vector<std::uint32_t>& markingOf,
                     const StateTree& markings) const;

  const System& system;
  std::string main;
  GraphKind kind;
  std::vector<std::string> labels;
  std::unordered_map<std::string, std::uint32_t> numberOfLabel;
  std::unordered_map<std::uint64_t, std::uint32_t> numberOfNode;
  std::vector<std::uint32_t> markingOf; ///< by node
  std::vector<StateGraph::Edge> edges;  ///< between nodes
};

} // namespace proskill::verify
