#pragma once

#include "verify/progress/explored_nodes.h"
#include "verify/space/zone_graph.h"

namespace proskill::verify {

/// The nodes of a graph in memory.
class GraphNodes : public ExploredNodes {
public:
  /// \pre the argument outlives this, and gets no more nodes
  explicit GraphNodes(ZoneGraph& of) : ExploredNodes(of.enabling, of.timing), graph(of) {}

  void rewind() override { following = 0; }
  [[nodiscard]] bool next() override {
    while (following < graph.size() && graph.isSubsumed(following)) ++following;
    return following++ < graph.size();
  }
  [[nodiscard]] std::uint64_t node() const override { return following - 1; }
  [[nodiscard]] std::uint64_t state() const override { return graph.stateOf(following - 1); }
  [[nodiscard]] SignatureId signature() override {
    return graph.signatureOf(graph.stateOf(following - 1));
  }
  void readState(Word* to) const override { graph.states.read(graph.stateOf(following - 1), to); }
  [[nodiscard]] Dbm zone() const override {
    return graph.timing.zones().zone(graph.zoneOf(following - 1));
  }
  void forget() override {} // all of it is needed
  [[nodiscard]] Progress progress() const override {
    return {.classes = graph.size(), .markings = graph.states.size(), .bytes = graph.bytes()};
  }
  [[nodiscard]] std::uint64_t growth() const override { return graph.growth(); }

private:
  const ZoneGraph& graph;
  NodeIndex following = 0; ///< the node after the current one
};

} // namespace proskill::verify
