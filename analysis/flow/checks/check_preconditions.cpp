#include "analysis/flow/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <fmt/format.h>

/// Finds unsatisfiable conditions of skills, and calls that are always refused.
namespace proskill::analysis::flow {

namespace {

using syntax::Code;

/// The first condition that contradicts those before it; the number of conditions if there is none.
std::size_t firstConflict(State state, const std::vector<Condition>& conditions) {
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    refine(state, conditions[i], true);
    if (!state.reachable) return i;
  }
  return conditions.size();
}

/// Names and places of a skill's preconditions or guards.
struct Part {
  syntax::Name tag;
  syntax::Range range;
};

/// The first condition that cannot hold together with those before it, whatever the state.
std::size_t firstContradiction(const State& any, const std::vector<Condition>& conditions) {
  for (std::size_t i = 0; i < conditions.size(); ++i)
    if (!mayHoldTogether(any, {conditions.begin(), i + 1})) return i;
  return conditions.size();
}

bool reportConflict(Report& report, syntax::CodeFor<3> code, const Definition<syntax::Skill>& skill,
                    const std::vector<Part>& parts, const State& state,
                    const std::vector<Condition>& conditions) {
  std::size_t conflict = firstContradiction(state, conditions);
  if (conflict == conditions.size()) return false;
  const bool alone = !mayHold(state, conditions[conflict]);
  const std::string_view together = alone ? "" : " together with those before it";
  Finding finding = report.findings.report(code, skill.at(parts[conflict].range),
                                           parts[conflict].tag.text, skill.name(), together);
  if (alone) return true;
  for (std::size_t i = 0; i < conflict; ++i)
    finding.related(skill.at(parts[i].range), "does not go together with this one");
  return true;
}

/// Hints at conditions that are true wherever those before them are.
void reportRedundant(Report& report, syntax::CodeFor<3> code,
                     const Definition<syntax::Skill>& skill, const std::vector<Part>& parts,
                     const State& state, const std::vector<Condition>& conditions) {
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (mayFailBeside(state, {conditions.begin(), i}, conditions[i])) continue;
    const bool alone = !mayFailBeside(state, {}, conditions[i]);
    report.findings.report(code, skill.at(parts[i].range), parts[i].tag.text, skill.name(),
                           alone ? "" : " where those before it do");
  }
}

class Preconditions {
public:
  explicit Preconditions(Report& report) : report(report) {}

  void check() {
    for (std::size_t i = 0; i < report.program.skills.all.size(); ++i) checkSkill(i);
    forEachReachedNode(report, [this](ProcessId id, const Process&, NodeId node, const Node& each) {
      if (each.kind == NodeKind::Call) checkCall(id, node, each);
    });
  }

private:
  void checkSkill(std::size_t index) {
    const auto& skill = report.program.skills.all[index];
    const Process& process = report.system()[report.system().ofSkill(index)];
    std::vector<Part> parts;
    for (const auto& each : skill->preconditions) parts.push_back({each.tag, each.range});
    const State any = anyState(report, process);
    const auto& conditions = process.actions[0].conditions;
    if (reportConflict(report, Code::ContradictoryPreconditions, skill, parts, any, conditions))
      contradictory.insert(report.system().ofSkill(index)), blameSkill(report, index);
    else
      reportRedundant(report, Code::PreconditionAlwaysHolds, skill, parts, any, conditions);
  }

  void checkCall(ProcessId id, NodeId nodeId, const Node& node) {
    ProcessId target = report.system()[id].actions[nodeId].target;
    if (target == kNoProcess) return;
    const Process& callee = report.system()[target];
    const auto& conditions = callee.actions[0].conditions;
    State entry;
    std::size_t conflict = 0;
    for (const State& one : report.solver.atCallee(id, nodeId)) {
      conflict = firstConflict(one, conditions);
      if (conflict == conditions.size()) return;
      entry.join(one);
    }
    report.explain(id, nodeId);
    blameSkill(report, callee.definition);
    if (contradictory.contains(target)) return;
    const auto& skill = report.program.skills.all[callee.definition];
    const syntax::Precondition& precondition = skill->preconditions[conflict];
    Finding finding =
        report.findings.report(Code::CallAlwaysRefused,
                               report.system().at(report.system()[id], node.statement->head.range),
                               skill.name(), precondition.tag.text);
    finding.related(skill.at(precondition.range), "needs this");
    addValues(finding, report, callee, entry, {conditions[conflict]});
  }

  Report& report;
  std::set<ProcessId> contradictory;
};

/// Finds guards that contradict each other, or that the start of the skill makes false.
class Guards {
public:
  explicit Guards(Report& report) : report(report) {}

  void check() {
    for (std::size_t i = 0; i < report.program.skills.all.size(); ++i) checkSkill(i);
  }

private:
  void checkSkill(std::size_t index) {
    const auto& skill = report.program.skills.all[index];
    ProcessId id = report.system().ofSkill(index);
    const Process& process = report.system()[id];
    std::vector<Part> parts;
    std::vector<Condition> guards;
    for (NodeId node = 0; node < process.actions.size(); ++node)
      if (const syntax::Invariant* invariant = (*process.graph)[node].invariant) {
        parts.push_back({invariant->tag, invariant->range});
        guards.push_back(process.actions[node].conditions.front());
      }
    State state = anyState(report, process);
    if (reportConflict(report, Code::ContradictoryInvariants, skill, parts, state, guards)) return;
    reportRedundant(report, Code::InvariantAlwaysHolds, skill, parts, state, guards);
    refineAll(state, process.actions[0].conditions, true);
    if (!state.reachable) return;
    state = report.solver.after(std::move(state), process, 0);
    for (std::size_t i = 0; i < guards.size(); ++i)
      if (!mayHold(state, guards[i]) && lasts(id, guards[i])) {
        Finding finding = report.findings.report(
            Code::StartBreaksInvariant, skill.at(parts[i].range), parts[i].tag.text, skill.name());
        addValues(finding, report, process, state, {guards[i]});
      } else if (mayBreak(process, {guards.begin(), i}, guards[i])) {
        report.findings.report(Code::StartMayBreakInvariant, skill.at(parts[i].range),
                               parts[i].tag.text, skill.name());
      }
  }

  /// Whether the start effects can make a guard false where the preconditions hold. The guards
  /// before it are true then. Asked of libraries only, in which any call is possible.
  [[nodiscard]] bool mayBreak(const Process& process, std::span<const Condition> before,
                              const Condition& guard) const {
    const auto isComposite = [](const auto& skill) { return skill->isComposite(); };
    if (std::ranges::any_of(report.program.skills.all, isComposite)) return false;
    std::set<Slot> slots;
    collectSlots(guard, slots);
    for (const Condition& each : before) collectSlots(each, slots);
    return isPossible(everyState(report, process), process.actions[0].conditions, slots,
                      [&](const State& state) {
                        const State after = report.solver.after(state, process, 0);
                        return mayFail(after, guard) && mayHoldTogether(after, before);
                      });
  }

  /// Whether a guard stays false until it is tested. Bodies test guards where they wait; earlier
  /// effects may make them true, and without a wait they are never tested.
  [[nodiscard]] bool lasts(ProcessId id, const Condition& guard) const {
    const Process& process = report.system()[id];
    if (!report.system().skill(process).isComposite()) return true;
    if (!report.solver.started(id)) return false;
    std::set<NodeId> seen{0};
    std::vector<NodeId> next{0};
    bool waits = false;
    while (!next.empty()) {
      NodeId node = next.back();
      next.pop_back();
      const Node& each = (*process.graph)[node];
      if (each.kind == NodeKind::Outcome || each.kind == NodeKind::Fork) return false;
      if (each.waits()) {
        if (report.solver.mayHold(id, node, guard)) return false;
        waits = true;
        continue;
      }
      for (const Edge& edge : each.edges) {
        bool follows = edge.target != kNoNode && report.solver.reachable(id, edge.target) &&
                       (*process.graph)[edge.target].kind != NodeKind::Refused;
        if (follows && seen.insert(edge.target).second) next.push_back(edge.target);
      }
    }
    return waits;
  }

  Report& report;
};

} // namespace

void checkPreconditions(Report& report) {
  Preconditions(report).check();
  Guards(report).check();
}

} // namespace proskill::analysis::flow
