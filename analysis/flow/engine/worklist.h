#pragma once

#include "analysis/flow/engine/call_order.h"

#include <cstddef>
#include <map>

namespace proskill::analysis::flow {

/// Processes to be analysed, taken like stops of a lift: up from callees to callers, then down
/// again. So everything new at the ends of callees travels up a long chain of calls in one pass,
/// and everything new at their entries travels down in one pass. If callees always came first, each
/// caller would send its news down the chain separately.
class Worklist {
public:
  [[nodiscard]] bool empty() const { return waiting.empty(); }
  /// \param rank of the call order; no other process has it
  void add(std::size_t rank, ProcessId process) { waiting.emplace(rank, process); }
  /// The next process in the current direction; if there is none, in the other direction. \pre not
  /// empty
  ProcessId take() {
    auto next = goesUp ? waiting.lower_bound(floor) : waiting.upper_bound(floor);
    if (next == (goesUp ? waiting.end() : waiting.begin())) goesUp = !goesUp;
    if (!goesUp) --next;
    const auto [rank, process] = *next;
    waiting.erase(next);
    floor = rank;
    return process;
  }

private:
  std::map<std::size_t, ProcessId> waiting; ///< by rank
  std::size_t floor = ~std::size_t{0};
  bool goesUp = false;
};

} // namespace proskill::analysis::flow
