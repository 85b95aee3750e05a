#pragma once

#include "analysis/flow/domain/id_set.h"

#include <vector>

namespace proskill::analysis::flow {

using ProcessId = std::uint32_t;

/// An order of all processes in which callees come before their callers.
class CallOrder {
public:
  /// \param started by process: the processes that it calls or forks
  explicit CallOrder(std::vector<std::vector<ProcessId>> started);

  /// The position of a process in the order.
  [[nodiscard]] std::size_t rank(ProcessId id) const { return ranks[id]; }
  /// Adds to the set of each process the sets of all processes that it starts, directly or
  /// indirectly.
  void closeOver(std::vector<IdSet>& sets) const;
  /// For each process, the first `most` members of the sets of all processes that it starts.
  [[nodiscard]] std::vector<IdSet> inherited(const std::vector<IdSet>& sets,
                                             std::size_t most) const;

private:
  void visit(ProcessId root, std::vector<bool>& seen);

  std::vector<std::vector<ProcessId>> started;
  std::vector<ProcessId> order;
  std::vector<std::size_t> ranks;
};

} // namespace proskill::analysis::flow
