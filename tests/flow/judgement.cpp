#include "tests/flow/judgement.h"

#include "analysis/flow/flow.h"
#include "analysis/flow/result/durations.h"
#include "analysis/flow/result/report.h"
#include "codegen/model.h"
#include "codegen/term/build.h"
#include "syntax/diagnostics/codes.h"
#include "tests/flow/questions.h"
#include "tests/support/texts.h"
#include "verify/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace proskill::test {

namespace {

using namespace analysis::flow;
using analysis::Location;
using syntax::Code;
using syntax::Diagnostic;

constexpr std::uint64_t kMostClasses = 30'000;

/// What the engine has decided.
struct Verdict {
  codegen::Check check;
  Location place;
  bool happens = false; ///< the tag, the state, or the property's condition can be reached
};

class Judgement {
public:
  explicit Judgement(const std::string& source)
      : text(source),
        program(programOfText(text)),
        index(analysis::analyse(program)),
        valid(std::ranges::none_of(index.diagnostics, [](const Diagnostic& each) {
          return each.severity == syntax::Severity::Error;
        })) {}

  Judged result() {
    if (!valid) return {};
    System system(program);
    Solver solver(system);
    analysis::Findings findings;
    Report made{program, solver, index.index, findings};
    report = &made;
    found = checkFlow(program, index.index);
    for (const Diagnostic& each : found) ++judged.codes[std::string(syntax::info(each.code).id)];
    queries = questionsOf(made, found);
    if (!decide(textWithQueries())) return {};
    judged.decided = true;
    for (const Verdict& verdict : verdicts) judge(verdict);
    for (const Diagnostic& each : found) judgeCertain(each);
    judgeMended();
    return std::move(judged);
  }

private:
  [[nodiscard]] std::string textWithQueries() const {
    std::string asked = text;
    for (std::size_t i = 0; i < queries.size(); ++i)
      if (queries[i].variable.empty())
        asked += fmt::format("\n(defproperty query_{} (reachable {}))", i, queries[i].words);
    return asked;
  }

  // Answers --------------------------------------------------------------------------------------

  bool decide(const std::string& source) {
    verdicts.clear();
    analysis::Program asked = programOfText(source);
    auto model = codegen::generate(asked);
    if (!model) return false;
    for (std::size_t i = 0; i < queries.size(); ++i)
      if (!queries[i].variable.empty()) askOfModel(*model, i);
    std::vector<verify::Question> questions;
    for (const auto& check : model->checks) questions.push_back({check.property});
    verify::Options options;
    options.limits.classes = kMostClasses;
    auto result = verify::verify(model->fiacre, model->provenance, questions, options);
    if (!result || !result->exploration.complete) return false;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      if (result->answers[i].truth == verify::Truth::Unknown) continue;
      const auto& origin = model->provenance.origins[model->checks[i].origin];
      verdicts.push_back({model->checks[i],
                          {origin.file, {origin.begin, origin.end}},
                          result->answers[i].truth == verify::Truth::False});
    }
    return true;
  }

  /// The name that the generator has given it: where another has it already, with a `_` behind it.
  static std::string nameIn(const codegen::Model& model, const std::string& variable) {
    std::string found = variable;
    for (const fiacre::Variable& each : model.fiacre.components.back().variables)
      if (each.name.starts_with(variable) &&
          each.name.find_first_not_of('_', variable.size()) == std::string::npos)
        found = each.name; // resources come last
    return found;
  }

  /// A query that no property of ProSkill can say.
  void askOfModel(codegen::Model& model, std::size_t query) const {
    const std::string name = nameIn(model, queries[query].variable);
    fiacre::Observable seen{
        .kind = fiacre::ObservableKind::Value,
        .value = codegen::equal(codegen::name(name), codegen::number(queries[query].value))};
    fiacre::Property property{.name = fmt::format("query_{}", query)};
    property.pattern.operands.push_back(std::move(seen));
    model.checks.push_back({.name = queries[query].words,
                            .kind = "property",
                            .subject = property.name,
                            .property = model.fiacre.properties.size()});
    model.fiacre.properties.push_back(std::move(property));
  }

  [[nodiscard]] const Verdict* find(std::string_view kind, Location place) const {
    auto here = std::ranges::find_if(verdicts, [&](const Verdict& each) {
      return each.check.kind == kind && each.place == place;
    });
    return here == verdicts.end() ? nullptr : &*here;
  }

  [[nodiscard]] const Verdict* findOf(std::string_view kind, std::string_view subject) const {
    auto here = std::ranges::find_if(verdicts, [&](const Verdict& each) {
      return each.check.kind == kind && each.check.subject == subject;
    });
    return here == verdicts.end() ? nullptr : &*here;
  }

  // What can never happen ------------------------------------------------------------------------

  void refute(const std::string& words) { judged.refuted.push_back(words); }

  void judge(const Verdict& verdict) {
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
      refute("impossible, but it happens: " + verdict.check.name + " " + verdict.check.words);
  }

  [[nodiscard]] bool judgeQuery(const Verdict& verdict) const {
    const std::string& name = verdict.check.subject;
    if (!name.starts_with("query_")) return true;
    return queries[std::stoul(name.substr(6))].possible;
  }

  [[nodiscard]] bool reaches(Location place) const {
    bool reached = false;
    forEachReachedNode(*report, [&](ProcessId, const Process& process, NodeId, const Node& node) {
      if (!node.statement) return;
      reached |= report->system().at(process, node.statement->range) == place;
      // A loop `do` is reached with its body.
      reached |= holdsPlace(process, place) && node.statement->range.begin >= place.range.begin &&
                 node.statement->range.end <= place.range.end;
    });
    return reached;
  }

  [[nodiscard]] bool holdsPlace(const Process& process, Location place) const {
    bool loops = false;
    for (const Node& node : process.graph->nodes)
      loops |= node.statement && node.statement->kind == syntax::StatementKind::DoUntil &&
               report->system().at(process, node.statement->range) == place;
    return loops;
  }

  [[nodiscard]] ProcessId processOf(std::string_view skill) const {
    return report->system().ofSkill(program.skills.byName.at(skill));
  }

  [[nodiscard]] bool canRun(std::string_view skill) const {
    ProcessId id = processOf(skill);
    if (!report->solver.started(id)) return false;
    State entry = report->solver.before(id, 0);
    refineAll(entry, report->system()[id].actions[0].conditions, true);
    return entry.reachable;
  }

  [[nodiscard]] bool returns(const Verdict& verdict, const std::string& kind) const {
    bool possible = false;
    forEachReachedNode(
        *report, [&](ProcessId id, const Process& process, NodeId, const Node& node) {
          if (id != processOf(verdict.check.subject) || node.kind != NodeKind::Outcome) return;
          if (node.success != (kind == "can_succeed")) return;
          possible |=
              !node.outcome || report->system().at(process, node.outcome->range) == verdict.place;
        });
    return possible;
  }

  [[nodiscard]] bool reachesNode(const Verdict& verdict, NodeKind kind) const {
    bool possible = false;
    forEachReachedNode(*report,
                       [&](ProcessId id, const Process& process, NodeId, const Node& node) {
                         possible |= id == processOf(verdict.check.subject) && node.kind == kind &&
                                     report->system().at(process, node.range) == verdict.place;
                       });
    return possible;
  }

  /// Before its start too.
  [[nodiscard]] bool mayBeInterrupted(const Verdict& verdict) const {
    ProcessId skill = processOf(verdict.check.subject);
    return report->solver.started(skill) &&
           (report->solver.mayBeInterrupted(skill) || report->solver.mayBeStopped(skill));
  }

  [[nodiscard]] bool mayBeRefused(const Verdict& verdict) const {
    if (verdict.check.name != verdict.check.subject + ".never_refused")
      return mayBeRefused(verdict.place);
    ProcessId root = processOf(verdict.check.subject);
    State entry = report->solver.before(root, 0);
    refineAll(entry, report->system()[root].actions[0].conditions, false);
    return entry.reachable;
  }

  [[nodiscard]] bool mayBeRefused(Location place) const {
    bool possible = false;
    forEachReachedNode(
        *report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
          if (each.kind != NodeKind::Call || report->at(id, node) != place) return;
          for (State entry : report->solver.atCallee(id, node)) {
            refineAll(entry, report->system()[process.actions[node].target].actions[0].conditions,
                      false);
            possible |= entry.reachable;
          }
        });
    return possible;
  }

  [[nodiscard]] bool mayBeBusy(Location place) const {
    ProcessId callee = kNoProcess;
    forEachNode(*report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
      if (each.kind == NodeKind::Call && report->at(id, node) == place)
        callee = process.actions[node].target;
    });
    if (report->system()[callee].repeats) return true; // whoever uses the library may run it
    auto names = [&](const Diagnostic& each) {
      return within(each.location, place) ||
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

  /// The call whose first word stands there calls the skill, directly or not.
  [[nodiscard]] bool leadsTo(Location head, ProcessId skill) const {
    bool leads = false;
    forEachNode(*report, [&](ProcessId, const Process& process, NodeId node, const Node& each) {
      if (each.kind == NodeKind::Call &&
          report->system().at(process, each.statement->head.range) == head)
        leads |= report->system().activity(process.actions[node].target).contains(skill);
    });
    return leads;
  }

  [[nodiscard]] bool mayBreakPostcondition(Location place) const {
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

  [[nodiscard]] bool mayMiss(const Verdict& verdict) const {
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

  /// An undershoot of a run that somebody stops is not what the analysis speaks of.
  [[nodiscard]] bool mayBeCutShort(const Verdict& verdict) const {
    return verdict.check.kind == "no_undershoot" && isCutShort(processOf(verdict.check.subject));
  }

  [[nodiscard]] bool isCutShort(ProcessId id) const {
    bool fails = report->solver.mayBeInterrupted(id) || report->solver.mayBeStopped(id);
    forEachReachedNode(*report, [&](ProcessId each, const Process&, NodeId, const Node& node) {
      fails |= each == id && node.kind == NodeKind::InvariantFailure;
    });
    return fails;
  }

  [[nodiscard]] bool mayMoveWrongly(const std::string& variable) {
    constexpr Code kMoves[] = {Code::ForbiddenMove, Code::MayBeForbiddenMove,
                               Code::LeavesRange,   Code::EventMayBeForbidden,
                               Code::MayLeaveRange, Code::EventMayLeaveRange};
    return std::ranges::any_of(found, [&](const Diagnostic& each) {
      return std::ranges::find(kMoves, each.code) != std::end(kMoves) &&
             each.message.contains("`" + variable + "`");
    });
  }

  // What is certain ------------------------------------------------------------------------------

  /// `happened` is what makes the claim matter, `expected` what must come of it.
  void demand(const Diagnostic& claim, const Verdict* happened, const Verdict* expected) {
    if (!happened || !expected || !happened->happens) return;
    ++judged.certain;
    if (!expected->happens)
      refute(fmt::format("certain, but it never happens: {} {}, though {}",
                         syntax::info(claim.code).id, claim.message, happened->check.name));
  }

  void judgeCertain(const Diagnostic& claim) {
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
    case Code::AlwaysTooShort: demandOfSkill(claim, "no_undershoot"); return;
    case Code::AlwaysTooLong: demandOfSkill(claim, "no_overshoot"); return;
    default: return;
    }
  }

  /// A statement in the body of the `while` or `do` whose first word stands at the place, if no way
  /// that is known leads out of it: else somebody may end the loop at the instant at which it
  /// spins.
  [[nodiscard]] const Verdict* insideEndlessLoop(Location head) const {
    const Verdict* inside = nullptr;
    forEachReachedNode(
        *report, [&](ProcessId id, const Process& process, NodeId, const Node& each) {
          if (!each.statement || report->system().at(process, each.statement->head.range) != head)
            return;
          const Location loop = report->system().at(process, each.statement->range);
          if (!spins(id, loop)) return;
          for (const Verdict& verdict : verdicts)
            if (verdict.check.kind == "reachable" && within(verdict.place, loop) &&
                verdict.place != loop && (!inside || verdict.happens))
              inside = &verdict;
        });
    return inside;
  }

  [[nodiscard]] bool spins(ProcessId id, Location loop) const {
    const Process& process = report->system()[id];
    bool spins = true;
    forEachReachedNode(*report, [&](ProcessId other, const Process&, NodeId node,
                                    const Node& each) {
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

  void demandOfSkill(const Diagnostic& claim, std::string_view kind) {
    const Verdict* expected = find(kind, claim.location);
    const Verdict* progress = findOf("time_progress", "program");
    if (!expected || !progress || progress->happens) return; // the clock may stand still before
    bool ends = false;
    for (const Verdict& each : verdicts)
      ends |= each.check.subject == expected->check.subject && each.happens &&
              (each.check.kind == "can_succeed" || each.check.kind == "can_fail");
    if (ends) demand(claim, findOf("can_run", expected->check.subject), expected);
  }

  /// The program with the intervals that the analysis has found, and without the transitions that
  /// it says nobody makes: then the intervals are kept, and no more moves are wrong than before.
  void judgeMended() {
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
    std::string mended = text.substr(0, program.files[0].document.text().size());
    std::ranges::sort(edits, std::ranges::greater(),
                      [](const Edit& edit) { return edit.at.range.begin; });
    for (const Edit& edit : edits)
      mended.replace(edit.at.range.begin, edit.at.range.length(), edit.text);
    if (!decide(mended)) return;
    for (const Verdict& verdict : verdicts) {
      const std::string& kind = verdict.check.kind;
      bool possible = true;
      if (kind == "no_undershoot" || kind == "no_overshoot")
        possible = !isRewritten(verdict) || mayBeCutShort(verdict);
      if (kind == "no_forbidden_transition") possible = mayMoveWrongly(verdict.check.subject);
      if (!possible) ++judged.impossible;
      if (!possible && verdict.happens)
        refute("impossible when mended, but it happens: " + verdict.check.name + "\n" + mended);
    }
  }

  [[nodiscard]] bool isOneOfMore(const Diagnostic& claim) const {
    return program.stateVariables.find(quoted(claim.message)[0])->node().transitions.size() > 1;
  }

  /// A diagnostic has rewritten the interval of the verdict's skill.
  [[nodiscard]] bool isRewritten(const Verdict& verdict) const {
    return std::ranges::any_of(found, [&](const Diagnostic& each) {
      bool isOfTime = each.code == Code::AlwaysTooShort || each.code == Code::AlwaysTooLong ||
                      each.code == Code::MayMissInterval;
      return isOfTime && quoted(each.message)[0] == verdict.check.subject;
    });
  }

  /// The verdict about what makes the effects at this place happen.
  [[nodiscard]] const Verdict* whatSets(Location place) const {
    for (const Verdict& each : verdicts)
      if (each.check.kind == "reachable" && isSet(each.place) && within(place, each.place))
        return isGuarded(each) ? nullptr : &each;
    // Not `can_be_interrupted`: what is interrupted before its start sets nothing.
    if (const Verdict* outcome =
            enclosing(place, {"can_succeed", "can_fail", "invariant_may_fail"}))
      return outcome;
    for (const auto& skill : program.skills.all)
      for (const auto& effect : skill->start.items)
        if (skill.at(effect.range) == place) return findOf("can_run", skill.name());
    for (const auto& event : program.events.all)
      for (const auto& effect : event->effects.items)
        if (event.at(effect.range) == place) return occurs(event.name());
    return nullptr;
  }

  [[nodiscard]] const Verdict* occurs(std::string_view event) const {
    auto asked = std::ranges::find(queries, fmt::format("(occurs {})", event), &Query::words);
    if (asked == queries.end()) return nullptr;
    return findOf("property", fmt::format("query_{}", asked - queries.begin()));
  }

  /// A guard that fails may end the skill before the step.
  [[nodiscard]] bool isGuarded(const Verdict& verdict) const {
    const auto skill = program.skills.byName.find(verdict.check.subject);
    return skill != program.skills.byName.end() &&
           !program.skills.all[skill->second]->invariants.empty();
  }

  /// Of `set` alone: a wait with effects may be reached and never end.
  [[nodiscard]] bool isSet(Location place) const {
    return std::string_view(text).substr(place.range.begin).starts_with("(set");
  }

  static bool within(Location inner, Location outer) {
    return inner.file == outer.file && outer.range.begin <= inner.range.begin &&
           inner.range.end <= outer.range.end;
  }

  [[nodiscard]] const Verdict* enclosing(Location place,
                                         std::initializer_list<std::string_view> kinds) const {
    for (const Verdict& each : verdicts)
      if (std::ranges::find(kinds, each.check.kind) != kinds.end() && within(place, each.place))
        return &each;
    return nullptr;
  }

  std::string text;
  analysis::Program program;
  analysis::Analysis index;
  bool valid;
  Report* report = nullptr;
  std::vector<Query> queries;
  std::vector<Diagnostic> found;
  std::vector<Verdict> verdicts;
  Judged judged;
};

} // namespace

Judged judge(const std::string& program) { return Judgement(program).result(); }

} // namespace proskill::test
