#include "analysis/flow/engine/call_order.h"

#include <utility>

namespace proskill::analysis::flow {

CallOrder::CallOrder(std::vector<std::vector<ProcessId>> all) : started(std::move(all)) {
  std::vector<bool> seen(started.size());
  for (ProcessId id = 0; id < started.size(); ++id) visit(id, seen);
  ranks.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = i;
}

/// With an explicit stack, since chains of calls may be long.
void CallOrder::visit(ProcessId root, std::vector<bool>& seen) {
  if (seen[root]) return;
  seen[root] = true;
  std::vector<std::pair<ProcessId, std::size_t>> stack{{root, 0}};
  while (!stack.empty()) {
    auto& [id, next] = stack.back();
    if (next == started[id].size()) {
      order.push_back(id);
      stack.pop_back();
      continue;
    }
    ProcessId callee = started[id][next++];
    if (seen[callee]) continue;
    seen[callee] = true;
    stack.emplace_back(callee, 0);
  }
}

void CallOrder::closeOver(std::vector<IdSet>& sets) const {
  // One pass is enough unless the program is recursive, which another check reports. Even then the
  // result must be correct.
  for (bool grew = true; grew;) {
    grew = false;
    for (ProcessId id : order)
      for (ProcessId next : started[id]) grew |= next != id && sets[id].insertAll(sets[next]);
  }
}

/// In one pass; for recursive programs, the result is less precise.
std::vector<IdSet> CallOrder::inherited(const std::vector<IdSet>& sets, std::size_t most) const {
  std::vector<IdSet> all(sets.size());
  for (ProcessId id : order)
    for (ProcessId next : started[id]) {
      if (next == id) continue;
      all[id].insertAll(sets[next]);
      all[id].insertAll(all[next]);
      all[id].keepFirst(most);
    }
  return all;
}

} // namespace proskill::analysis::flow
