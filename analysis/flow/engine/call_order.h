#pragma once

#include "analysis/flow/domain/id_set.h"

#include <vector>

namespace proskill::analysis::flow {

using ProcessId = std::uint32_t;

/// Who starts whom, in an order in which those who are started come first.
class CallOrder {
public:
  /// `started` has for each process what it calls or forks.
  explicit CallOrder(std::vector<std::vector<ProcessId>> started);

  /// The place of a process in the order.
  [[nodiscard]] std::size_t rank(ProcessId id) const { return ranks[id]; }
  /// Adds to the set of each process those of all that it starts, directly or not.
  void closeOver(std::vector<IdSet>& sets) const;
  /// For each process, of the sets of all that it starts, the first `most` members.
  [[nodiscard]] std::vector<IdSet> inherited(const std::vector<IdSet>& sets,
                                             std::size_t most) const;

private:
  void visit(ProcessId root, std::vector<bool>& seen);

  std::vector<std::vector<ProcessId>> started;
  std::vector<ProcessId> order;
  std::vector<std::size_t> ranks;
};

} // namespace proskill::analysis::flow
