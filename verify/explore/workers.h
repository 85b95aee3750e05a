#pragma once

#include "verify/explore/expander.h"
#include "verify/threads/team.h"

#include <atomic>
#include <memory>

namespace proskill::verify {

/// Threads that compute what is possible from the next nodes of a breadth-first search. While they
/// do, nothing is added to the graph but claims of states, so they read it without locks. What else
/// each of them changes is its own: zones, caches, and the counters of its limits.
class Workers {
public:
  /// \pre the arguments outlive this
  Workers(const System& system, const OpenGoals& goals, const Reductions& reductions,
          ZoneGraph& graph, const LimitWatch& limits, unsigned jobs);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  /// The end of the nodes that are expanded together if this node is the first of them.
  [[nodiscard]] NodeIndex endOfChunk(NodeIndex node) const;
  /// What is possible from a node, in terms of the graph. Successors that the graph covered when
  /// this was computed are missing; they are covered for ever. Call this from one thread, for
  /// ascending nodes.
  /// \throw LimitMet
  [[nodiscard]] const Expansion& expansionOf(NodeIndex node);

private:
  /// What one thread works with.
  class Worker;

  [[nodiscard]] bool hasExpanded(NodeIndex node) const { return first <= node && node < end; }
  void prepareClaims();
  void expandChunk();
  void work(std::size_t worker);

  ZoneGraph& graph;
  std::vector<std::unique_ptr<Worker>> all; ///< the first one works in the calling thread

  NodeIndex first = 0; ///< of the chunk
  NodeIndex end = 0;
  std::vector<Expansion> chunk;
  std::vector<std::uint32_t> makers; ///< by node of the chunk: index in `all`
  std::atomic<NodeIndex> next{0};    ///< the next node of the chunk that nobody works at

  Team team; ///< last, so that its threads end first
};

} // namespace proskill::verify
