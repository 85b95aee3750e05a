#include "tests/flow/flow_claims.h"

#include "analysis/flow/result/durations.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

#include <optional>
#include <set>

namespace proskill::test {

namespace {

constexpr std::size_t kMostRelatedCalls = 10; ///< of one finding about a skill that may be busy

} // namespace

void Judgement::judge(const Verdict& verdict) {
  const std::string& kind = verdict.check.kind;
  bool possible = true;
  if (kind == "property") possible = judgeQuery(verdict);
  if (kind == "reachable") possible = reaches(verdict.place);
  if (kind == "can_run") possible = canRun(verdict.check.subject);
  if (kind == "can_succeed" || kind == "can_fail") possible = returns(verdict, kind);
  if (kind == "invariant_may_fail") possible = reachesNode(verdict, NodeKind::InvariantFailure);
  if (kind == "can_be_interrupted") possible = mayBeInterrupted(verdict);
  if (kind == "never_refused") possible = mayBeRefused(verdict);
  if (kind == "never_busy") possible = mayBeBusy(verdict.place);
  if (kind == "postcondition") possible = mayBreakPostcondition(verdict.place);
  if (kind == "no_forbidden_transition") possible = mayMoveWrongly(verdict.check.subject);
  if (kind == "no_undershoot" || kind == "no_overshoot") possible = mayMiss(verdict);
  if (!possible) ++judged.impossible;
  if (!possible && verdict.happens)
    refute("impossible, but it happens: " + verdict.check.name + " " + verdict.check.description);
}

bool Judgement::judgeQuery(const Verdict& verdict) const {
  const std::string& name = verdict.check.subject;
  if (!name.starts_with("query_")) return true;
  return queries[std::stoul(name.substr(6))].possible;
}

bool Judgement::reaches(Location place) const {
  bool reached = false;
  forEachReachedNode(*report, [&](ProcessId, const Process& process, NodeId, const Node& node) {
    if (!node.statement) return;
    reached |= report->system().at(process, node.statement->range) == place;
    // A `do` is reached if its body is.
    reached |= holdsPlace(process, place) && node.statement->range.begin >= place.range.begin &&
               node.statement->range.end <= place.range.end;
  });
  return reached;
}

bool Judgement::holdsPlace(const Process& process, Location place) const {
  bool loops = false;
  for (const Node& node : process.graph->nodes)
    loops |= node.statement && node.statement->kind == syntax::StatementKind::DoUntil &&
             report->system().at(process, node.statement->range) == place;
  return loops;
}

ProcessId Judgement::processOf(std::string_view skill) const {
  return report->system().ofSkill(program.skills.byName.at(skill));
}

bool Judgement::canRun(std::string_view skill) const {
  ProcessId id = processOf(skill);
  if (!report->solver.started(id)) return false;
  State entry = report->solver.before(id, 0);
  refineAll(entry, report->system()[id].actions[0].conditions, true);
  return entry.reachable;
}

bool Judgement::returns(const Verdict& verdict, const std::string& kind) const {
  bool possible = false;
  forEachReachedNode(*report, [&](ProcessId id, const Process& process, NodeId, const Node& node) {
    if (id != processOf(verdict.check.subject) || node.kind != NodeKind::Outcome) return;
    if (node.success != (kind == "can_succeed")) return;
    possible |= !node.outcome || report->system().at(process, node.outcome->range) == verdict.place;
  });
  return possible;
}

bool Judgement::reachesNode(const Verdict& verdict, NodeKind kind) const {
  bool possible = false;
  forEachReachedNode(*report, [&](ProcessId id, const Process& process, NodeId, const Node& node) {
    possible |= id == processOf(verdict.check.subject) && node.kind == kind &&
                report->system().at(process, node.range) == verdict.place;
  });
  return possible;
}

bool Judgement::mayBeInterrupted(const Verdict& verdict) const {
  ProcessId skill = processOf(verdict.check.subject);
  return report->solver.started(skill) &&
         (report->solver.mayBeInterrupted(skill) || report->solver.mayBeStopped(skill));
}

bool Judgement::mayBeRefused(const Verdict& verdict) const {
  if (verdict.check.name != verdict.check.subject + ".never_refused")
    return mayBeRefused(verdict.place);
  ProcessId root = processOf(verdict.check.subject);
  State entry = report->solver.before(root, 0);
  refineAll(entry, report->system()[root].actions[0].conditions, false);
  return entry.reachable;
}

bool Judgement::mayBeRefused(Location place) const {
  bool possible = false;
  forEachReachedNode(*report, [&](ProcessId id, const Process& process, NodeId node,
                                  const Node& each) {
    if (each.kind != NodeKind::Call || report->at(id, node) != place) return;
    for (State entry : report->solver.atCallee(id, node)) {
      refineAll(entry, report->system()[process.actions[node].target].actions[0].conditions, false);
      possible |= entry.reachable;
    }
  });
  return possible;
}

bool Judgement::mayBeBusy(Location place) const {
  ProcessId callee = kNoProcess;
  forEachNode(*report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
    if (each.kind == NodeKind::Call && report->at(id, node) == place)
      callee = process.actions[node].target;
  });
  if (report->system()[callee].repeats) return true; // a user of the library may run it
  const auto names = [&](const Diagnostic& each) {
    const auto& skill = report->system().skill(report->system()[callee]);
    const bool isCutShort = each.related.size() == kMostRelatedCalls;
    return within(each.location, place) ||
           (isCutShort && quoted(each.message)[0] == skill.name.text) ||
           std::ranges::any_of(each.related, [&](const syntax::Related& related) {
             return within(related.location, place);
           });
  };
  for (const Diagnostic& each : found)
    if (each.code == Code::CallMayWait && names(each)) return true;
  return std::ranges::any_of(index.diagnostics, [&](const Diagnostic& each) {
    return each.code == Code::MayBeRunning && leadsTo(each.location, callee);
  });
}

bool Judgement::leadsTo(Location head, ProcessId skill) const {
  bool leads = false;
  forEachNode(*report, [&](ProcessId, const Process& process, NodeId node, const Node& each) {
    if (each.kind == NodeKind::Call &&
        report->system().at(process, each.statement->head.range) == head)
      leads |= report->system().activity(process.actions[node].target).contains(skill);
  });
  return leads;
}

bool Judgement::mayBreakPostcondition(Location place) const {
  bool possible = false;
  forEachReachedNode(
      *report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
        if (!each.outcome || !each.outcome->postcondition) return;
        if (report->system().at(process, each.outcome->postcondition->range) != place) return;
        Condition condition =
            report->system().resolver().condition(*each.outcome->postcondition, process.slots);
        for (const State& before : report->solver.cases(id, node))
          possible |= mayFail(report->solver.afterEffects(before, process, node), condition);
      });
  return possible;
}

bool Judgement::mayMiss(const Verdict& verdict) const {
  Durations durations(report->solver);
  ProcessId id = processOf(verdict.check.subject);
  const auto& skill = program.skills.all[report->system()[id].definition];
  auto duration = report->solver.started(id) ? durations.of(id) : std::nullopt;
  if (!skill->isComposite() || !duration || mayBeCutShort(verdict)) return true;
  const syntax::Interval& interval = *skill->timeInterval;
  if (verdict.check.kind == "no_undershoot")
    return duration->least < interval.lower ||
           (duration->least == interval.lower && interval.lowerOpen);
  return !duration->most || *duration->most > *interval.upper ||
         (*duration->most == *interval.upper && interval.upperOpen);
}

bool Judgement::mayBeCutShort(const Verdict& verdict) const {
  return verdict.check.kind == "no_undershoot" && isCutShort(processOf(verdict.check.subject));
}

bool Judgement::isCutShort(ProcessId id) const {
  bool fails = report->solver.mayBeInterrupted(id) || report->solver.mayBeStopped(id);
  forEachReachedNode(*report, [&](ProcessId each, const Process&, NodeId, const Node& node) {
    fails |= each == id && node.kind == NodeKind::InvariantFailure;
  });
  return fails;
}

bool Judgement::mayMoveWrongly(const std::string& variable) {
  constexpr Code kMoves[] = {Code::ForbiddenMove, Code::MayBeForbiddenMove,
                             Code::LeavesRange,   Code::EventMayBeForbidden,
                             Code::MayLeaveRange, Code::EventMayLeaveRange};
  return std::ranges::any_of(found, [&](const Diagnostic& each) {
    return std::ranges::find(kMoves, each.code) != std::end(kMoves) &&
           each.message.contains("`" + variable + "`");
  });
}

} // namespace proskill::test
