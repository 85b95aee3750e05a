#include "graph/components.h"

#include <catch2/catch.hpp>

#include <random>

using namespace proskill::graph;

namespace {

using Arcs = std::vector<std::vector<Node>>;

std::vector<Node> componentsOf(const Arcs& arcs) {
  return proskill::graph::componentsOf(arcs.size(), [&](Node node, std::size_t i) {
    return i < arcs[node].size() ? arcs[node][i] : kNoNode;
  });
}

/// By definition: reachability as the transitive closure of the arcs.
std::vector<std::vector<bool>> reachability(const Arcs& arcs) {
  std::vector<std::vector<bool>> reaches(arcs.size(), std::vector<bool>(arcs.size()));
  for (Node node = 0; node < arcs.size(); ++node) {
    reaches[node][node] = true;
    for (Node target : arcs[node]) reaches[node][target] = true;
  }
  for (Node by = 0; by < arcs.size(); ++by)
    for (Node from = 0; from < arcs.size(); ++from)
      for (Node to = 0; to < arcs.size(); ++to)
        if (reaches[from][by] && reaches[by][to]) reaches[from][to] = true;
  return reaches;
}

Arcs randomArcs(std::mt19937& random) {
  Arcs arcs(1 + random() % 12);
  const std::size_t most = 1 + random() % 3;
  for (auto& from : arcs)
    for (std::size_t i = random() % (most + 1); i > 0; --i)
      from.push_back(static_cast<Node>(random() % arcs.size()));
  return arcs;
}

} // namespace

TEST_CASE("components: two nodes are in one where each can be reached from the other") {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    const Arcs arcs = randomArcs(random);
    const auto component = componentsOf(arcs);
    const auto reaches = reachability(arcs);
    for (Node a = 0; a < arcs.size(); ++a) {
      REQUIRE(component[component[a]] == component[a]);
      for (Node b = 0; b < arcs.size(); ++b)
        REQUIRE((component[a] == component[b]) == (reaches[a][b] && reaches[b][a]));
    }
  }
}

TEST_CASE("components: a chain and a circle of a million nodes need no deep stack") {
  constexpr Node kNodes = 1'000'000;
  auto next = [](Node node, std::size_t i) {
    return i == 0 && node + 1 < kNodes ? node + 1 : kNoNode;
  };
  const auto chain = proskill::graph::componentsOf(kNodes, next);
  CHECK(chain[0] != chain[kNodes - 1]);
  auto around = [](Node node, std::size_t i) { return i == 0 ? (node + 1) % kNodes : kNoNode; };
  const auto circle = proskill::graph::componentsOf(kNodes, around);
  CHECK(circle[0] == circle[kNodes - 1]);
}
