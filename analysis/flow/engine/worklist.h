#pragma once

#include "analysis/flow/engine/call_order.h"

#include <cstddef>
#include <map>

namespace proskill::analysis::flow {

/// Processes that have something to do, taken like a lift: up from those who are called to their
/// callers, and down again. So all that is new at the ends of the called comes up a long chain of
/// calls in one go, and all that is new at the entries goes down in one. If who is called always
/// came first, each caller would send what it has learnt down the chain by itself.
class Worklist {
public:
  [[nodiscard]] bool empty() const { return waiting.empty(); }
  /// `rank` is that of the call order: no other process has it.
  void add(std::size_t rank, ProcessId process) { waiting.emplace(rank, process); }
  /// The next in this direction, or where there is none, in the other. \pre not empty
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
