#include "analysis/flow/checks/checks.h"
#include "analysis/flow/checks/loop_statement.h"

#include "analysis/flow/result/loops.h"
#include "syntax/diagnostics/codes.h"

/// Finds loops in which no time passes, and waits without delay.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

class Progress {
public:
  Progress(Report& report, ProcessId id) : report(report), id(id), process(report.system()[id]) {}

  void check() {
    auto within = [this](NodeId node) {
      return report.solver.reachable(id, node) && takesNoTime(process, node);
    };
    for (const std::vector<NodeId>& loop : loopsOf(*process.graph, within))
      if (!mayLeave(loop)) tell(loop);
  }

private:
  /// Whether the loop counts to its end, or may choose to leave.
  [[nodiscard]] bool mayLeave(const std::vector<NodeId>& loop) const {
    std::set<NodeId> inside(loop.begin(), loop.end());
    std::set<VariableId> changed;
    for (NodeId node : loop)
      for (const Assignment& each : process.actions[node].assignments)
        changed.insert(each.variable);
    for (NodeId node : loop) {
      bool leaves = false;
      for (const Edge& edge : (*process.graph)[node].edges) {
        if (edge.stops && reads(edge.target, changed)) return true;
        leaves |= !edge.stops && !inside.contains(edge.target);
      }
      if (leaves && ((*process.graph)[node].kind != NodeKind::Test || reads(node, changed)))
        return true;
    }
    return false;
  }

  [[nodiscard]] bool reads(NodeId node, const std::set<VariableId>& variables) const {
    std::set<Slot> slots;
    for (const Condition& each : process.actions[node].conditions) collectSlots(each, slots);
    for (Slot slot : slots)
      if (variables.contains(process.slots[slot])) return true;
    return false;
  }

  void tell(const std::vector<NodeId>& loop) {
    const syntax::Statement& statement = loopStatement(process, loop);
    Finding finding =
        report.findings.report(Code::LoopWithoutTime, beginOf(report, process, statement));
    for (NodeId node : loop)
      if (isExit(node, loop))
        finding.related(report.at(id, node), "nothing in the loop changes what is tested here");
    offerWait(finding, report, process, statement);
  }

  [[nodiscard]] bool isExit(NodeId node, const std::vector<NodeId>& loop) const {
    const Node& each = (*process.graph)[node];
    return each.kind == NodeKind::Test && std::ranges::any_of(each.edges, [&](const Edge& edge) {
             return !edge.stops && edge.target != kNoNode &&
                    std::ranges::find(loop, edge.target) == loop.end();
           });
  }

  Report& report;
  ProcessId id;
  const Process& process;
};

void checkZeroWait(Report& report, ProcessId id, NodeId nodeId, const Node& node) {
  if (node.kind != NodeKind::Delay || !takesNoTime(report.system()[id], nodeId)) return;
  Location at = report.at(id, nodeId);
  report.findings.report(Code::ZeroWait, at)
      .fix("remove the wait", withSpaceAround(report, at), "");
}

} // namespace

void checkProgress(Report& report) {
  forEachNode(report, [&](ProcessId id, const Process&, NodeId node, const Node& each) {
    if (node == 0) Progress(report, id).check();
    checkZeroWait(report, id, node, each);
  });
}

} // namespace proskill::analysis::flow
