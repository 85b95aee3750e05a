#include "verify/graph/graph_recorder.h"

#include "verify/graph/tina_names.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <tuple>

namespace proskill::verify {

namespace {

using Edge = StateGraph::Edge;

/// Edges by source, in the order in which they were found.
class Successors {
public:
  Successors(const std::vector<Edge>& all, std::size_t nodes) : first(nodes + 1) {
    for (const auto& edge : all) ++first[edge.source + 1];
    for (std::size_t i = 0; i < nodes; ++i) first[i + 1] += first[i];
    ordered.resize(all.size());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (const auto& edge : all) ordered[next[edge.source]++] = edge;
  }
  [[nodiscard]] std::span<const Edge> of(std::uint32_t node) const {
    return {ordered.data() + first[node], first[node + 1] - first[node]};
  }

private:
  std::vector<std::size_t> first;
  std::vector<Edge> ordered;
};

void unite(std::vector<Edge>& edges) {
  const auto key = [](const Edge& edge) {
    return std::tuple(edge.source, edge.label, edge.target);
  };
  std::ranges::sort(edges, {}, key);
  const auto twice = std::ranges::unique(edges, {}, key);
  edges.erase(twice.begin(), twice.end());
}

} // namespace

std::uint32_t GraphRecorder::label(TransitionId transition, const StepLog& log) {
  auto name = tinaTransition(system, transition, log);
  auto [entry, added] =
      numberOfLabel.try_emplace(std::move(name), static_cast<std::uint32_t>(labels.size()));
  if (added) labels.push_back(entry->first);
  return entry->second;
}

std::uint32_t GraphRecorder::node(Class of) {
  const bool merged = kind == GraphKind::Markings;
  const std::uint64_t key = std::uint64_t{of.marking} << 32 | (merged ? 0 : of.domain);
  auto [entry, added] = numberOfNode.try_emplace(key, static_cast<std::uint32_t>(markingOf.size()));
  if (added) markingOf.push_back(of.marking);
  return entry->second;
}

void GraphRecorder::edge(Class from, std::uint32_t label, Class to) {
  const auto source = node(from);
  edges.push_back({source, label, node(to)});
}

std::uint64_t GraphRecorder::bytes() const {
  constexpr std::uint64_t kOfNode = 48; // memory of an entry of the table, its bucket and its
                                        // marking
  return edges.capacity() * sizeof(Edge) + numberOfNode.size() * kOfNode;
}

StateGraph GraphRecorder::graph(Class initial, const StateTree& markings) const {
  auto united = edges;
  if (kind == GraphKind::Markings) unite(united);
  const std::size_t nodes = std::max<std::size_t>(markingOf.size(), 1);
  const Successors successors(united, nodes);
  StateGraph graph{.labels = labels};
  std::vector<std::uint32_t> stateOf(nodes, kNone);
  std::vector<std::uint32_t> order{0};
  if (!markingOf.empty()) {
    const bool merged = kind == GraphKind::Markings;
    order[0] =
        numberOfNode.at(std::uint64_t{initial.marking} << 32 | (merged ? 0 : initial.domain));
  }
  stateOf[order[0]] = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const auto& edge : successors.of(order[i])) {
      if (stateOf[edge.target] == kNone) {
        stateOf[edge.target] = static_cast<std::uint32_t>(order.size());
        order.push_back(edge.target);
      }
      graph.edges.push_back({static_cast<std::uint32_t>(i), edge.label, stateOf[edge.target]});
    }
  std::vector<std::uint32_t> stored;
  for (auto node : order) stored.push_back(markingOf.empty() ? initial.marking : markingOf[node]);
  addProperties(graph, stored, markings);
  return graph;
}

/// Names the properties of markings: places in the order of the instances, then variables.
void GraphRecorder::addProperties(StateGraph& graph, const std::vector<std::uint32_t>& stored,
                                  const StateTree& markings) const {
  std::vector<std::uint32_t> firstPlace;
  std::vector<CellId> variables;
  std::vector<bool> isLocation(system.cells.size());
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    firstPlace.push_back(static_cast<std::uint32_t>(graph.properties.size()));
    isLocation[system.instances[i].location] = true;
    for (std::uint32_t at = 0; at < system.instances[i].locations.size(); ++at)
      graph.properties.push_back(tinaPlace(system, i, at));
  }
  const auto firstVariable = static_cast<std::uint32_t>(graph.properties.size());
  for (CellId cell = 0; cell < system.cells.size(); ++cell) {
    if (isLocation[cell]) continue;
    variables.push_back(cell);
    graph.properties.push_back(tinaVariable(system, cell, main));
  }
  std::unordered_map<std::uint32_t, std::uint32_t> numberOf;
  std::vector<Word> state(system.words);
  for (auto marking : stored) {
    auto [entry, added] =
        numberOf.try_emplace(marking, static_cast<std::uint32_t>(graph.markings.size()));
    graph.markingOf.push_back(entry->second);
    if (!added) continue;
    markings.read(marking, state.data());
    auto& has = graph.markings.emplace_back();
    for (InstanceId i = 0; i < system.instances.size(); ++i) {
      const auto at = readCell(system, system.instances[i].location, state.data());
      has.emplace_back(firstPlace[i] + static_cast<std::uint32_t>(at), 1);
    }
    for (std::size_t i = 0; i < variables.size(); ++i)
      if (auto value = readCell(system, variables[i], state.data()); value != 0)
        has.emplace_back(firstVariable + static_cast<std::uint32_t>(i), value);
  }
}

} // namespace proskill::verify
