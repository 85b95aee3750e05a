#include "codegen/process/composite.h"

#include "codegen/process/body_process.h"
#include "codegen/term/conditions.h"
#include "codegen/term/grounds.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::codegen {
namespace {

using fiacre::Expr;
using fiacre::Statement;
using syntax::StatementKind;

/// The skills and branches that a thread may wait for, without duplicates.
std::vector<std::string_view> calleesOf(const BodyAutomaton& thread) {
  std::vector<std::string_view> callees;
  const auto add = [&](std::string_view name) {
    if (std::ranges::find(callees, name) == callees.end()) callees.push_back(name);
  };
  for (const auto& state : thread.states) {
    if (state.statement && state.statement->kind == StatementKind::Call)
      add(state.statement->head.text);
    for (const auto& branch : state.branches) add(branch.name);
  }
  return callees;
}

Ending endingOf(const SkillPlan& skill, const syntax::Statement& statement) {
  return statement.kind == StatementKind::Success ? successOf(skill, statement.name.text)
                                                  : failureOf(skill, statement.name.text);
}

/// The end of a body whose invariant has failed, after everything that it called has been stopped.
Ending endAfterFailureOf(const syntax::Invariant& invariant) {
  auto ending = failureOf(invariant);
  ending.description = fmt::format("ends because of its invariant `{}`", invariant.tag.text);
  ending.wasNoticed = true;
  return ending;
}

/// The common part of the processes of a skill and of its branches. Both may be stopped, and then
/// stop what they called before they end.
class StoppableBody : public BodyProcess {
protected:
  StoppableBody(Context& context, const SkillPlan& skill, const BodyAutomaton& body)
      : BodyProcess(context, body, actorOf(skill, body), name(context.names.cell(body.name))),
        skill(skill) {}

  /// Stops the running callees, and goes to the state that waits for their ends.
  Statement stopCallees(Statement trigger, const std::vector<std::string_view>& running,
                        Statement reason) {
    hasStopping = true;
    std::vector<Statement> all{std::move(trigger)};
    for (const auto callee : running) all.push_back(calls.stop(callee));
    if (body.path.empty() && skill.mayLinger() && someHoldsOut(running))
      all.push_back(assign(context.cellField(skill.name(), "ending"), boolean(true)));
    all.push_back(std::move(reason));
    all.push_back(to("stopping"));
    return sequence(std::move(all));
  }

  void addStopping(fiacre::Process& process, Statement end) {
    if (!hasStopping) return;
    std::vector<Expr> gone;
    std::vector<Statement> all{atOnce()};
    std::vector<Statement> releases;
    for (const auto callee : calleesOf(body)) {
      gone.push_back(calls.isGone(callee));
      if (!body.racers.empty()) releases.push_back(keepOutcomeOfStopped(callee));
      releases.push_back(calls.release(callee));
    }
    all.push_back(on(conjunction(std::move(gone))));
    all.push_back(sequence(std::move(releases)));
    all.push_back(std::move(end));
    addState(process, "stopping", process.origin, sequence(std::move(all)),
             "Nothing that it called is left running.");
  }

  /// Whether all guards of the skill are true, and no other branch has won an enclosing race.
  Expr mayStep() override {
    std::vector<Expr> all;
    for (const auto& invariant : skill.skill().invariants)
      all.push_back(condition(context, invariant.guard));
    for (const auto& racer : body.racers) all.push_back(negation(context.cellField(racer, "stop")));
    return conjunction(std::move(all));
  }

  Expr mayGoOn() override {
    if (!skill.branchEnds) return boolean(true);
    return equal(name(context.names.outcome(skill.name())), name("no_result"));
  }

  const SkillPlan& skill;

private:
  [[nodiscard]] bool someHoldsOut(const std::vector<std::string_view>& running) const {
    return std::ranges::any_of(
        running, [&](std::string_view each) { return context.plan.holdOuts.contains(each); });
  }

  bool hasStopping = false;
};

class MainBody : public StoppableBody {
public:
  MainBody(Context& context, const SkillPlan& skill)
      : StoppableBody(context, skill, *skill.body), frame(context, skill), reasons(findReasons()) {}

  fiacre::Process make() {
    fiacre::Process process;
    process.name = context.names.process({"skill", skill.name()});
    process.origin = frame.place();
    process.comment = context.definitionOf(*skill.definition);
    const auto entry = context.isExpanded() ? std::string("body_branch") : body.entry;
    frame.addStart(process, entry);
    if (context.isExpanded())
      addState(process, entry, frame.place(), sequence({atOnce(), to(body.entry)}));
    addBody(process);
    addStopping(process, endForReason());
    frame.addRest(process);
    if (reasons.size() > 1 && hasReason)
      process.variables.push_back(
          {"stopping", namedType("skill_result"), name("no_result"), "why it has to end"});
    return process;
  }

private:
  /// Everything outside its own thread that can end the skill.
  std::vector<Ending> findReasons() {
    std::vector<Ending> found;
    if (skill.obeysStops() || skill.skill().interrupt) found.push_back(interruptionOf(skill));
    for (const auto& invariant : skill.skill().invariants)
      found.push_back(endAfterFailureOf(invariant));
    forEachThread(body, [&](const BodyAutomaton& thread) {
      if (thread.path.empty()) return;
      for (const auto& state : thread.states)
        if (state.statement && (state.statement->kind == StatementKind::Success ||
                                state.statement->kind == StatementKind::Failure))
          addReason(found, endingOf(skill, *state.statement));
    });
    return found;
  }

  static void addReason(std::vector<Ending>& found, Ending ending) {
    const auto same = [&](const Ending& it) {
      return it.status == ending.status && it.tag.text == ending.tag.text;
    };
    if (std::ranges::none_of(found, same)) found.push_back(std::move(ending));
  }

  Expr resultOf(const Ending& ending) {
    return context.result(skill.name(), ending.status, ending.tag.text);
  }

  Statement note(const Expr& reason) {
    hasReason = true;
    return reasons.size() > 1 ? assign(name("stopping"), reason) : sequence({});
  }

  std::vector<Statement> abortStatements(const std::vector<std::string_view>& running,
                                         bool joining) override {
    const auto& node = skill.skill();
    std::vector<Statement> all;
    const auto interruption = interruptionOf(skill);
    if (node.interrupt) {
      const auto words = frame.origin(interruption.range, outsideInterruptionOf(skill).description);
      auto port = at(words, synchronise(context.names.interruptPort(skill.name())));
      all.push_back(stopCallees(std::move(port), running, note(resultOf(interruption))));
    }
    if (skill.obeysStops())
      all.push_back(stopCallees(
          seen(frame.stop(), told(frame.stop(), interruption.range, "is asked to stop")), running,
          note(resultOf(interruption))));
    for (auto& failure : failedGuards(running)) all.push_back(std::move(failure));
    if (joining && skill.branchEnds) {
      const auto outcome = name(context.names.outcome(skill.name()));
      const auto ended = negation(mayGoOn());
      all.push_back(stopCallees(seen(ended, told(ended, node.name.range, "is ended by a branch")),
                                running, note(outcome)));
    }
    return all;
  }

  std::vector<Statement> abortStatementsWhereHeld() override { return failedGuards({}); }

  std::vector<Statement> failedGuards(const std::vector<std::string_view>& running) {
    std::vector<Statement> all;
    for (const auto& invariant : skill.skill().invariants) {
      const auto ending = failureOf(invariant);
      const auto words = frame.failsAt(frame.origin(ending.range, ending.description), invariant);
      context.alarms.emplace(words, Alarm::FailedInvariant);
      all.push_back(
          stopCallees(seen(frame.fails(invariant), words), running, note(resultOf(ending))));
    }
    return all;
  }

  OriginId told(const Expr& condition, syntax::Range range, std::string_view words) {
    return causedBy(context, frame.origin(range, words), condition);
  }

  static Statement seen(Expr condition, OriginId words) {
    return sequence({atOnce(), at(words, on(std::move(condition)))});
  }

  /// Ends for the recorded reason, and resets the outcome that a branch left.
  Statement endForReason() {
    if (reasons.empty()) return sequence({});
    auto chain = frame.end(reasons.back());
    for (std::size_t i = reasons.size() - 1; i-- > 0;)
      chain = ifThenElse(equal(name("stopping"), resultOf(reasons[i])), frame.end(reasons[i]),
                         std::move(chain));
    if (!skill.branchEnds) return chain;
    return sequence(
        {assign(name(context.names.outcome(skill.name())), name("no_result")), std::move(chain)});
  }

  std::optional<Statement> atEnd() override { return frame.end(successOf(skill, {})); }

  Statement conclude(const syntax::Statement& statement) override {
    auto ending = endingOf(skill, statement);
    ending.range = statement.range;
    return frame.end(ending);
  }

  SkillFrame frame;
  std::vector<Ending> reasons;
  bool hasReason = false;
};

class BranchBody : public StoppableBody {
public:
  BranchBody(Context& context, const SkillPlan& skill, const BodyAutomaton& branch)
      : StoppableBody(context, skill, branch) {}

  fiacre::Process make() {
    fiacre::Process process;
    process.name = processOf(context, skill, body);
    process.origin = origin(range());
    process.comment =
        fmt::format("{}, {}", actor.name, context.origins.reference(actor.file, range()));
    if (context.isExpanded())
      addExpandedStart(process);
    else
      addState(process, "idle", process.origin,
               sequence({atOnce(), on(isCalled()), start(body.entry, "idle")}));
    addBody(process);
    addStopping(process, returnControl(range(), "is stopped"));
    if (context.isExpanded()) {
      addStep(process, "done", "ether");
      addStep(process, "ether", "start_");
    }
    return process;
  }

private:
  [[nodiscard]] syntax::Range range() const {
    return body.range.empty() ? skill.skill().name.range : body.range;
  }

  Expr isCalled() { return negation(calls.isFree(body.name)); }

  void addStep(fiacre::Process& process, std::string_view from, std::string_view next) {
    addState(process, from, process.origin, sequence({atOnce(), to(next)}));
  }

  void addExpandedStart(fiacre::Process& process) {
    addState(process, "start_", process.origin,
             sequence({atOnce(), on(isCalled()), start("body_branch", "done")}));
    addStep(process, "body_branch", body.entry);
  }

  Statement start(std::string_view first, std::string_view rest) {
    auto begin = at(causedBy(context, origin(range(), "starts"), isCalled()), to(first));
    if (!skill.mayStrike(body)) return begin;
    auto stopEarly = sequence({returnNow(range(), "is stopped before it starts"), to(rest)});
    return ifThenElse(context.cellField(body.name, "stop"), std::move(stopEarly), std::move(begin));
  }

  Statement returnNow(syntax::Range place, std::string_view words) {
    std::vector<Statement> all;
    if (skill.mayStrike(body))
      all.push_back(assign(context.cellField(body.name, "stop"), boolean(false)));
    all.push_back(
        at(origin(place, words), assign(context.cellField(body.name, "caller"), name("None"))));
    return sequence(std::move(all));
  }

  Statement returnControl(syntax::Range place, std::string_view words) {
    return sequence({returnNow(place, words), to(context.isExpanded() ? "done" : "idle")});
  }

  std::vector<Statement> abortStatements(const std::vector<std::string_view>& running,
                                         bool joining) override {
    static_cast<void>(joining);
    if (!skill.mayStrike(body)) return {};
    const auto stop = context.cellField(body.name, "stop");
    auto asked = at(causedBy(context, origin(range(), "is asked to stop"), stop), on(stop));
    return {stopCallees(sequence({atOnce(), std::move(asked)}), running, sequence({}))};
  }

  std::vector<Statement> abortStatementsWhereHeld() override { return abortStatements({}, false); }

  std::optional<Statement> atEnd() override {
    if (body.rivals.empty()) return returnControl(range(), "ends");
    std::vector<Statement> all;
    for (const auto& rival : body.rivals) all.push_back(calls.stop(rival));
    all.push_back(returnControl(range(), "ends first and wins the race"));
    return sequence(std::move(all));
  }

  /// The first branch that ends the skill determines the outcome.
  Statement conclude(const syntax::Statement& statement) override {
    const auto ending = endingOf(skill, statement);
    const auto words = fmt::format("ends `{}`, which {}", skill.name(), ending.description);
    const auto result = context.result(skill.name(), ending.status, ending.tag.text);
    auto decide = assign(name(context.names.outcome(skill.name())), result);
    return sequence({ifThen(mayGoOn(), std::move(decide)), returnControl(statement.range, words)});
  }
};

} // namespace

std::vector<fiacre::Process> compositeSkill(Context& context, const SkillPlan& skill) {
  std::vector<fiacre::Process> processes{MainBody(context, skill).make()};
  forEachThread(*skill.body, [&](const BodyAutomaton& thread) {
    if (!thread.path.empty()) processes.push_back(BranchBody(context, skill, thread).make());
  });
  if (skill.isWatched()) processes.push_back(watchdog(context, skill));
  return processes;
}

} // namespace proskill::codegen
