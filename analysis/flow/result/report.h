#pragma once

#include "analysis/flow/engine/solver.h"
#include "analysis/names/findings.h"
#include "analysis/names/index.h"

#include <map>
#include <set>
#include <string>
#include <utility>

namespace proskill::analysis::flow {

/// What the checks of this folder see, and where they put what they find.
struct Report {
  const Program& program;
  const Solver& solver;
  const Index& index;
  Findings& findings;
  /// Nodes of which something has been said that explains what follows; the checks that come later
  /// are silent about them.
  std::set<std::pair<ProcessId, NodeId>> explained{};
  /// Variables whose values have been told already.
  std::set<VariableId> told{};
  /// Variables of which it was told that one skill sets them while another relies on them.
  std::set<VariableId> disputed{};
  /// Statuses and results of skills of which it was told that they cannot start.
  std::set<VariableId> blamed{};
  /// Of statuses and results, the values of outcomes that the skill declares and never returns,
  /// which is told where it is defined.
  std::map<VariableId, ValueSet> unreturned{};

  [[nodiscard]] const System& system() const { return solver.system(); }
  [[nodiscard]] const Variables& variables() const { return solver.system().variables(); }
  [[nodiscard]] Location at(ProcessId process, NodeId node) const {
    const Process& self = system()[process];
    return system().at(self, (*self.graph)[node].range);
  }
  void explain(ProcessId process, NodeId node) { explained.emplace(process, node); }
  [[nodiscard]] bool isExplained(ProcessId process, NodeId node) const {
    return explained.contains({process, node});
  }
};

/// Where a variable is defined: its own name, or that of its skill or resource.
[[nodiscard]] Location definitionOf(const Report& report, VariableId variable);

/// Says of each variable of the conditions which values it can have in the state.
void addValues(Finding& finding, Report& report, const Process& process, const State& state,
               const std::vector<Condition>& conditions);

/// The variables that a condition reads.
void collectSlots(const Condition& condition, std::set<Slot>& slots);

/// What is said about a skill that cannot start also explains its status and its result.
void blameSkill(Report& report, std::size_t skill);
/// Some variable of the conditions has been blamed.
[[nodiscard]] bool isBlamed(const Report& report, const Process& process,
                            const std::vector<Condition>& conditions);

/// Fills `report.unreturned`.
void noteUnreturned(Report& report);
/// The condition of a node could hold, or fail, if the skills returned all that they declare.
[[nodiscard]] bool dependsOnUnreturned(const Report& report, ProcessId process, NodeId node,
                                       const Condition& condition, bool holds);

/// What a fix puts between a statement and one that it adds behind it: the same indentation on a
/// line of its own, where the statement begins its line; else a space.
[[nodiscard]] std::string lineAfter(const Report& report, Location statement);
/// A part of a text with the white space that goes when it is removed.
[[nodiscard]] Location withSpaceAround(const Report& report, Location part);

/// Calls `visit(id, process, nodeId, node)` for each node of each process that somebody starts.
template <class Visit> void forEachNode(const Report& report, Visit&& visit) {
  for (ProcessId id = 0; id < report.system().size(); ++id) {
    const Process& process = report.system()[id];
    if (!process.graph || !process.analysed) continue;
    for (NodeId node = 0; node < process.graph->nodes.size(); ++node)
      visit(id, process, node, (*process.graph)[node]);
  }
}

/// The same for the nodes that can be reached.
template <class Visit> void forEachReachedNode(const Report& report, Visit&& visit) {
  forEachNode(report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
    if (report.solver.reachable(id, node)) visit(id, process, node, each);
  });
}

} // namespace proskill::analysis::flow
