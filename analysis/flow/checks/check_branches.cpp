#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <map>

/// Finds parallel branches that set the same state variable, directly or by calls.
namespace proskill::analysis::flow {

namespace {

struct Written {
  Location at;
  bool locked = false; ///< set by test-and-set, like a lock
  bool counts = true;  ///< only counted up or down: the order does not matter
};
using Writes = std::map<VariableId, Written>;

bool reads(const Action& action, std::optional<Slot> slot) {
  std::set<Slot> slots;
  for (const Condition& condition : action.conditions) collectSlots(condition, slots);
  return slot && slots.contains(*slot);
}

class Branches {
public:
  explicit Branches(Report& report) : report(report) {}

  void check() {
    forEachReachedNode(report, [this](ProcessId, const Process& process, NodeId node, const Node&) {
      compareAll(process.actions[node].branches);
    });
  }

private:
  void compareAll(const std::vector<ProcessId>& branches) {
    std::vector<Writes> writes(branches.size());
    for (std::size_t i = 0; i < branches.size(); ++i) collect(branches[i], writes[i]);
    for (std::size_t i = 0; i < branches.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) compare(writes[j], writes[i]);
  }

  void collect(ProcessId id, Writes& writes) const {
    const Process& process = report.system()[id];
    for (NodeId node = 0; node < process.actions.size(); ++node) {
      if (!report.solver.reachable(id, node)) continue;
      for (ProcessId branch : process.actions[node].branches) collect(branch, writes);
      add(process.actions[node], report.at(id, node), writes);
      ProcessId callee = process.actions[node].target;
      if ((*process.graph)[node].kind == NodeKind::Call && callee != kNoProcess)
        collectCalled(callee, report.at(id, node), writes);
    }
  }

  /// Reports what a call sets at the call.
  void collectCalled(ProcessId callee, Location call, Writes& writes) const {
    forEach(report.system().activity(callee), [&](std::size_t id) {
      const auto process = static_cast<ProcessId>(id);
      for (NodeId node = 0; node < report.system()[process].actions.size(); ++node)
        if (report.solver.started(process) && report.solver.reachable(process, node))
          add(report.system()[process].actions[node], call, writes);
    });
  }

  static void add(const Action& action, Location at, Writes& writes) {
    for (const Assignment& each : action.assignments) {
      if (!each.source) continue;
      Written& written = writes.try_emplace(each.variable, Written{at}).first->second;
      written.locked |= reads(action, each.slot);
      written.counts &= stepOf(each).has_value();
    }
  }

  void compare(const Writes& first, const Writes& second) {
    for (const auto& [variable, written] : second) {
      auto other = first.find(variable);
      if (other == first.end() || (written.locked && other->second.locked)) continue;
      if (written.counts && other->second.counts) continue;
      if (report.disputed.contains(variable)) continue;
      report.findings
          .report(syntax::Code::BranchesSetSame, written.at, report.variables().name(variable))
          .related(other->second.at, "set in another branch too");
    }
  }

  Report& report;
};

} // namespace

void checkBranches(Report& report) { Branches(report).check(); }

} // namespace proskill::analysis::flow
