#include "tests/flow/flow_claims.h"

#include "analysis/flow/result/durations.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

#include <optional>
#include <set>

namespace proskill::test {

void Judgement::demand(const Diagnostic& claim, const Verdict* happened, const Verdict* expected) {
  if (!happened || !expected || !happened->happens) return;
  ++judged.certain;
  if (!expected->happens)
    refute(fmt::format("certain, but it never happens: {} {}, though {}",
                       syntax::info(claim.code).id, claim.message, happened->check.name));
}

void Judgement::judgeCertain(const Diagnostic& claim) {
  switch (claim.code) {
  case Code::ForbiddenMove:
  case Code::LeavesRange: {
    std::size_t from = claim.message.find('`') + 1;
    std::string variable = claim.message.substr(from, claim.message.find('`', from) - from);
    demand(claim, whatSets(claim.location), findOf("no_forbidden_transition", variable));
    return;
  }
  case Code::PostconditionNeverHolds:
    demand(claim, enclosing(claim.location, {"can_succeed", "can_fail"}),
           find("postcondition", claim.location));
    return;
  case Code::CallAlwaysRefused: {
    const Verdict* call = enclosing(claim.location, {"reachable"});
    // It may be stopped, interrupted, or wait for what it needs, before it is refused.
    if (call && isCutShort(processOf(call->check.subject))) return;
    if (!(*program.skills.find(quoted(claim.message)[0]))->resources.empty()) return;
    demand(claim, call, call ? find("never_refused", call->place) : nullptr);
    return;
  }
  case Code::ContradictoryInvariants:
  case Code::StartBreaksInvariant: {
    const std::string skill = quoted(claim.message)[1];
    if (claim.code == Code::ContradictoryInvariants &&
        program.skills.all[program.skills.byName.at(skill)]->isComposite())
      return; // its body may end before it waits for anything
    const Verdict* fails = nullptr;
    for (const Verdict& each : verdicts)
      if (each.check.kind == "invariant_may_fail" && each.check.subject == skill &&
          (!fails || each.happens))
        fails = &each;
    demand(claim, findOf("can_run", skill), fails);
    return;
  }
  case Code::LoopWithoutTime:
    demand(claim, insideEndlessLoop(claim.location), findOf("time_progress", "program"));
    return;
  case Code::RefusedInLoop:
  case Code::WaitsOnceInLoop: {
    // Parallel steps at the same date may help, and then time passes.
    const bool alone = std::ranges::count(report->system().all(), true, &Process::root) ==
                       (report->system().hasFreeEvents() ? 2 : 1);
    const auto* inside = enclosing(claim.related.at(0).location, {"reachable"});
    // A body that the loop calls may be called elsewhere too, and the loop never be reached.
    if (inside && !isIn(inside->check.subject, claim.location) &&
        report->system().callers(processOf(inside->check.subject)).size() > 1)
      return;
    const auto* refused = inside ? find("never_refused", inside->place) : nullptr;
    if (!alone || (claim.code == Code::RefusedInLoop && !(refused && refused->happens))) return;
    demand(claim, inside, findOf("time_progress", "program"));
    return;
  }
  case Code::AlwaysTooShort: demandOfSkill(claim, "no_undershoot"); return;
  case Code::AlwaysTooLong: demandOfSkill(claim, "no_overshoot"); return;
  default: return;
  }
}

bool Judgement::isIn(std::string_view skill, Location head) const {
  const auto definition = report->system()[processOf(skill)].definition;
  bool isIn = false;
  forEachReachedNode(*report, [&](ProcessId, const Process& process, NodeId, const Node& each) {
    isIn = isIn || (process.definition == definition && each.statement &&
                    report->system().at(process, each.statement->head.range) == head);
  });
  return isIn;
}

const Verdict* Judgement::insideEndlessLoop(Location head) const {
  const Verdict* inside = nullptr;
  forEachReachedNode(*report, [&](ProcessId id, const Process& process, NodeId, const Node& each) {
    if (!each.statement || report->system().at(process, each.statement->head.range) != head) return;
    const Location loop = report->system().at(process, each.statement->range);
    if (!spins(id, loop)) return;
    for (const Verdict& verdict : verdicts)
      if (verdict.check.kind == "reachable" && within(verdict.place, loop) &&
          verdict.place != loop && (!inside || verdict.happens))
        inside = &verdict;
  });
  return inside;
}

bool Judgement::spins(ProcessId id, Location loop) const {
  const Process& process = report->system()[id];
  bool spins = true;
  forEachReachedNode(*report, [&](ProcessId other, const Process&, NodeId node, const Node& each) {
    if (other != id || !each.statement) return;
    if (!within(report->system().at(process, each.statement->range), loop)) return;
    spins &= !each.waits();
    for (const Edge& edge : each.edges) {
      if (edge.target == kNoNode) continue;
      const syntax::Statement* next = (*process.graph)[edge.target].statement;
      if (next && within(report->system().at(process, next->range), loop)) continue;
      const auto& conditions = process.actions[node].conditions;
      bool never = edge.guard == Guard::Holds   ? !report->solver.mayHold(id, node, conditions[0])
                   : edge.guard == Guard::Fails ? !report->solver.mayFail(id, node, conditions[0])
                                                : false;
      spins &= never;
    }
  });
  return spins;
}

void Judgement::demandOfSkill(const Diagnostic& claim, std::string_view kind) {
  const Verdict* expected = find(kind, claim.location);
  const Verdict* progress = findOf("time_progress", "program");
  if (!expected || !progress || progress->happens) return; // time may stop before
  bool ends = false;
  for (const Verdict& each : verdicts)
    ends |= each.check.subject == expected->check.subject && each.happens &&
            (each.check.kind == "can_succeed" || each.check.kind == "can_fail");
  if (ends) demand(claim, findOf("can_run", expected->check.subject), expected);
}

void Judgement::judgeFixed() {
  struct Edit {
    Location at;
    std::string text;
  };
  std::vector<Edit> edits;
  std::set<std::string> thinned;
  for (const Diagnostic& each : found) {
    if (each.code == Code::AlwaysTooShort || each.code == Code::AlwaysTooLong ||
        each.code == Code::MayMissInterval)
      edits.push_back({each.fixes.front().location, each.fixes.front().text});
    if (each.code == Code::TransitionNeverMade && isOneOfMore(each) &&
        thinned.insert(quoted(each.message)[0]).second)
      edits.push_back({each.location, ""});
  }
  if (edits.empty()) return;
  std::string fixed = text.substr(0, program.files[0].document.text().size());
  std::ranges::sort(edits, std::ranges::greater(),
                    [](const Edit& edit) { return edit.at.range.begin; });
  for (const Edit& edit : edits)
    fixed.replace(edit.at.range.begin, edit.at.range.length(), edit.text);
  if (!decide(fixed)) return;
  for (const Verdict& verdict : verdicts) {
    const std::string& kind = verdict.check.kind;
    bool possible = true;
    if (kind == "no_undershoot" || kind == "no_overshoot")
      possible = !isRewritten(verdict) || mayBeCutShort(verdict);
    if (kind == "no_forbidden_transition") possible = mayMoveWrongly(verdict.check.subject);
    if (!possible) ++judged.impossible;
    if (!possible && verdict.happens)
      refute("impossible when fixed, but it happens: " + verdict.check.name + "\n" + fixed);
  }
}

bool Judgement::isOneOfMore(const Diagnostic& claim) const {
  return program.stateVariables.find(quoted(claim.message)[0])->node().transitions.size() > 1;
}

bool Judgement::isRewritten(const Verdict& verdict) const {
  return std::ranges::any_of(found, [&](const Diagnostic& each) {
    bool isOfTime = each.code == Code::AlwaysTooShort || each.code == Code::AlwaysTooLong ||
                    each.code == Code::MayMissInterval;
    return isOfTime && quoted(each.message)[0] == verdict.check.subject;
  });
}

const Verdict* Judgement::whatSets(Location place) const {
  for (const Verdict& each : verdicts)
    if (each.check.kind == "reachable" && isSet(each.place) && within(place, each.place))
      return isGuarded(each) ? nullptr : &each;
  // Not `can_be_interrupted`: an interrupt before the start has no effects.
  if (const Verdict* outcome = enclosing(place, {"can_succeed", "can_fail", "invariant_may_fail"}))
    return outcome;
  for (const auto& skill : program.skills.all)
    for (const auto& effect : skill->start.items)
      if (skill.at(effect.range) == place) return findOf("can_run", skill.name());
  for (const auto& event : program.events.all)
    for (const auto& effect : event->effects.items)
      if (event.at(effect.range) == place) return occurs(event.name());
  return nullptr;
}

const Verdict* Judgement::occurs(std::string_view event) const {
  auto asked = std::ranges::find(queries, fmt::format("(occurs {})", event), &Query::condition);
  if (asked == queries.end()) return nullptr;
  return findOf("property", fmt::format("query_{}", asked - queries.begin()));
}

bool Judgement::isGuarded(const Verdict& verdict) const {
  const auto skill = program.skills.byName.find(verdict.check.subject);
  return skill != program.skills.byName.end() &&
         !program.skills.all[skill->second]->invariants.empty();
}

bool Judgement::isSet(Location place) const {
  return std::string_view(text).substr(place.range.begin).starts_with("(set");
}

} // namespace proskill::test
