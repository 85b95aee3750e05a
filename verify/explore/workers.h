#pragma once

#include "verify/explore/expander.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

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

  [[nodiscard]] bool hasExpanded(NodeIndex node) const { return first <= node && node < end; }
  /// What is possible from a node, in terms of the graph. Successors that the graph covered when
  /// this was computed are missing; they are covered for ever. Call this from one thread, for
  /// ascending nodes.
  /// \throw LimitMet
  [[nodiscard]] const Expansion& expansionOf(NodeIndex node);

private:
  /// What one thread works with.
  class Worker;

  using Task = std::function<void(std::size_t)>;

  void runThread(std::size_t worker, const std::stop_token& stop);
  void inAllThreads(Task with);
  void attempt(std::size_t worker);
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

  std::mutex guard;
  std::condition_variable changed;
  Task task;                  ///< of all threads, called with the index of each
  std::uint64_t round = 0;    ///< number of tasks so far
  std::size_t busy = 0;       ///< number of threads that still work at the task
  std::exception_ptr failure; ///< thrown by one of them
  std::vector<std::jthread> threads;
};

} // namespace proskill::verify
