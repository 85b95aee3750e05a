#pragma once

#include "analysis/flow/engine/solver.h"
#include "analysis/names/findings.h"
#include "analysis/names/index.h"

#include <map>
#include <set>
#include <string>
#include <utility>

namespace proskill::analysis::flow {

/// The input of the checks of this folder, and where they report.
struct Report {
  const Program& program;
  const Solver& solver;
  const Index& index;
  Findings& findings;
  /// Nodes with a finding that explains what follows; later checks do not report them.
  std::set<std::pair<ProcessId, NodeId>> explained{};
  /// Variables whose values have already been reported.
  std::set<VariableId> told{};
  /// Variables with a finding that one skill sets them while another relies on them.
  std::set<VariableId> disputed{};
  /// Statuses and results of skills with a finding that they cannot start.
  std::set<VariableId> blamed{};
  /// Values of statuses and results for outcomes that the skill declares but never returns. The
  /// finding is at their definition.
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

/// Where a variable is defined: its own name, or the name of its skill or resource.
[[nodiscard]] Location definitionOf(const Report& report, VariableId variable);

/// Adds to a finding the possible values of each variable of the conditions in the state.
void addValues(Finding& finding, Report& report, const Process& process, const State& state,
               const std::vector<Condition>& conditions);

/// Any values of all variables of a process.
[[nodiscard]] State anyState(const Report& report, const Process& process);
/// All values that the variables of a process ever have.
[[nodiscard]] State everyState(const Report& report, const Process& process);

/// Notes that a finding about a skill that cannot start also explains its status and its result.
void blameSkill(Report& report, std::size_t skill);
/// Whether a variable of the conditions is blamed.
[[nodiscard]] bool isBlamed(const Report& report, const Process& process,
                            const std::vector<Condition>& conditions);

/// Fills `report.unreturned`.
void noteUnreturned(Report& report);
/// Whether the condition of a node could hold, or fail, if the skills returned all outcomes that
/// they declare.
[[nodiscard]] bool dependsOnUnreturned(const Report& report, ProcessId process, NodeId node,
                                       const Condition& condition, bool holds);

/// The white space that a fix puts between a statement and one that it adds after it: a new line
/// with the same indentation if the statement begins its line, otherwise a space.
[[nodiscard]] std::string lineAfter(const Report& report, Location statement);
/// A part of a text together with the white space to be removed with it.
[[nodiscard]] Location withSpaceAround(const Report& report, Location part);

/// Calls `visit(id, process, nodeId, node)` for each node of each process that is started.
template <class Visit> void forEachNode(const Report& report, Visit&& visit) {
  for (ProcessId id = 0; id < report.system().size(); ++id) {
    const Process& process = report.system()[id];
    if (!process.graph || !process.analysed) continue;
    for (NodeId node = 0; node < process.graph->nodes.size(); ++node)
      visit(id, process, node, (*process.graph)[node]);
  }
}

/// The same for reachable nodes only.
template <class Visit> void forEachReachedNode(const Report& report, Visit&& visit) {
  forEachNode(report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
    if (report.solver.reachable(id, node)) visit(id, process, node, each);
  });
}

} // namespace proskill::analysis::flow
