#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

/// Finds effects of one skill that violate an invariant of another that may be running.
namespace proskill::analysis::flow {

namespace {

/// An invariant of a skill, and the states in which it runs.
struct Watched {
  ProcessId process = kNoProcess;
  const syntax::Invariant* invariant = nullptr;
  const Condition* guard = nullptr;
  State inside; ///< in which the guard is true
};

class Breakers {
public:
  explicit Breakers(Report& report) : report(report) {
    forEachReachedNode(report,
                       [this](ProcessId id, const Process& process, NodeId node, const Node& each) {
                         if (each.kind == NodeKind::InvariantFailure)
                           watch(id, process, node, each.invariant);
                       });
  }

  void check() {
    forEachReachedNode(report,
                       [this](ProcessId id, const Process& process, NodeId node, const Node& each) {
                         if (each.kind != NodeKind::Emit)
                           for (const Assignment& assignment : process.actions[node].assignments)
                             if (assignment.source) visit(id, process, assignment);
                       });
  }

private:
  void watch(ProcessId id, const Process& process, NodeId node,
             const syntax::Invariant* invariant) {
    Watched watched{id, invariant, &process.actions[node].conditions.front(), {}};
    for (NodeId other = 0; other < process.graph->nodes.size(); ++other)
      if ((*process.graph)[other].waits()) watched.inside.join(report.solver.during(id, other));
    refine(watched.inside, *watched.guard, true);
    if (watched.inside.reachable) all.push_back(std::move(watched));
  }

  void visit(ProcessId id, const Process& process, const Assignment& assignment) {
    for (const Watched& watched : all) {
      if (!mayRunBeside(id, watched.process) || !breaks(assignment, watched)) continue;
      if (!told.insert({assignment.source, watched.invariant}).second) continue;
      const auto& skill = report.program.skills.all[report.system()[watched.process].definition];
      report.disputed.insert(assignment.variable);
      report.findings
          .report(syntax::Code::BreaksInvariant,
                  report.system().at(process, assignment.source->range),
                  watched.invariant->tag.text, skill.name())
          .related(skill.at(watched.invariant->range), "the invariant");
    }
  }

  [[nodiscard]] bool mayRunBeside(ProcessId writer, ProcessId watched) const {
    const System& system = report.system();
    if (writer == watched || system.exclusive(watched).contains(writer)) return false;
    return system.concurrent(watched).contains(writer) || system.activity(watched).contains(writer);
  }

  /// Whether the guard is false after the assignment, whatever the value was before.
  [[nodiscard]] bool breaks(const Assignment& assignment, const Watched& watched) const {
    const Process& process = report.system()[watched.process];
    auto slot = process.slots.find(assignment.variable);
    if (!slot || assignment.value.kind != Term::Kind::Number) return false;
    State state = watched.inside;
    state.values[*slot] = report.variables()[assignment.variable].domain.saturated(
        {assignment.value.number, assignment.value.number});
    return !mayHold(state, *watched.guard);
  }

  Report& report;
  std::vector<Watched> all;
  std::set<std::pair<const syntax::Effect*, const syntax::Invariant*>> told;
};

} // namespace

void checkInvariants(Report& report) { Breakers(report).check(); }

} // namespace proskill::analysis::flow
