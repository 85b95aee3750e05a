#include "codegen/process/body_process.h"

#include "codegen/message/message.h"
#include "codegen/term/conditions.h"
#include "codegen/term/effects.h"
#include "codegen/term/grounds.h"

#include "syntax/tree/statements.h"

#include <fmt/format.h>

#include <cassert>

namespace proskill::codegen {

using fiacre::Statement;
using syntax::StatementKind;

std::string syncState(const BodyState& state) {
  return state.name + "_" + (state.cases ? "case" : state.next) + "_sync";
}

std::string busyState(const BodyState& state) { return state.name + "_busy"; }

BodyProcess::BodyProcess(Context& context, const BodyAutomaton& body, Actor actor, fiacre::Expr me)
    : context(context), body(body), actor(std::move(actor)), calls(context, std::move(me)) {}

std::string BodyProcess::excerpt(syntax::Range range) const {
  return context.origins.excerpt(actor.file, range);
}

std::string BodyProcess::quote(syntax::Range range) const { return "`" + excerpt(range) + "`"; }

std::string BodyProcess::lineOf(const BodyState& state) const {
  return context.origins.reference(actor.file, state.statement->range);
}

Statement BodyProcess::watched(Statement main, std::vector<Statement> abortStatements) {
  abortStatements.insert(abortStatements.begin(), std::move(main));
  return select(std::move(abortStatements));
}

void BodyProcess::addBody(fiacre::Process& process) {
  for (const auto& state : body.states) {
    if (state.statement) {
      addStatement(process, state);
    } else if (auto end = atEnd()) {
      addState(process, state.name, process.origin,
               unlessHeld(sequence({atOnce(), std::move(*end)})), "The end of the body.");
    } else {
      process.states.push_back({state.name, process.origin});
    }
  }
}

void BodyProcess::addStatement(fiacre::Process& process, const BodyState& state) {
  const auto& statement = *state.statement;
  switch (statement.kind) {
  case StatementKind::Call: return addCall(process, state);
  case StatementKind::Parallel:
  case StatementKind::Race: return addParallel(process, state);
  case StatementKind::WaitCondition: return addWaiting(process, state, whenItMay(waitFor(state)));
  case StatementKind::WaitTime: {
    // a guard that fails and is true again at once must not restart the clock
    const auto words =
        origin(statement.range, "has waited " + excerpt(statement.duration.range) + " s");
    return addWaiting(
        process, state,
        sequence({wait(context.times.waiting(statement.duration)), at(words, to(state.next))}));
  }
  case StatementKind::Interrupt:
  case StatementKind::If:
  case StatementKind::While:
  case StatementKind::DoUntil:
  case StatementKind::Choose:
  case StatementKind::Break:
  case StatementKind::Goto:
  case StatementKind::Set:
  case StatementKind::Printf:
  case StatementKind::Success:
  case StatementKind::Failure:
  case StatementKind::Emit:
    return addState(process, state.name, origin(statement.range), unlessHeld(step(state)),
                    lineOf(state));
  case StatementKind::Case:         // has the state of its call
  case StatementKind::Unknown:      // makes the program erroneous
  case StatementKind::Label: break; // has no state of its own
  }
  assert(false && "a statement without a state");
}

/// A step without delay. While the body must not continue, the alternatives remain.
Statement BodyProcess::unlessHeld(Statement step) {
  auto goesOn = mayStep();
  if (isTrue(goesOn)) return step;
  return ifThenElse(std::move(goesOn), std::move(step), select(abortStatementsWhereHeld()));
}

/// A step that the body waits for.
Statement BodyProcess::whenItMay(Statement main) {
  return sequence({on(mayStep()), std::move(main)});
}

void BodyProcess::addWaiting(fiacre::Process& process, const BodyState& state, Statement main) {
  auto others = abortStatements({}, false);
  if (syntax::hasTimeout(*state.statement)) others.insert(others.begin(), timeOut(state));
  addState(process, state.name, origin(state.statement->range),
           watched(std::move(main), std::move(others)), lineOf(state));
}

/// A forbidden move among the effects says more than the wait, so its description comes last.
Statement BodyProcess::waitFor(const BodyState& state) {
  const auto& statement = *state.statement;
  const auto words = origin(statement.range, "has waited for " + quote(statement.condition.range));
  auto guard = on(conditionIn(body.name, context, statement.condition));
  decidedBy(context, words, conditionIn(body.name, context, statement.condition), true);
  auto next = to(state.next);
  const bool isPlain = statement.effects.items.empty() || guard.kind != fiacre::StatementKind::On;
  (isPlain ? next : guard).origin = words;
  return sequence(
      {atOnce(), std::move(guard), effects(context, actor, statement.effects), std::move(next)});
}

Statement BodyProcess::timeOut(const BodyState& state) {
  const auto& statement = *state.statement;
  const auto words =
      fmt::format("has waited {} s for {} and gives up", excerpt(statement.duration.range),
                  quote(statement.condition.range));
  return sequence({wait(context.times.waiting(statement.duration)),
                   at(origin(statement.range, words), to(state.targets[0]))});
}

Statement BodyProcess::step(const BodyState& state) {
  const auto& statement = *state.statement;
  const auto goOn = [&](std::string_view words) {
    return at(origin(statement.range, words), to(state.next));
  };
  switch (statement.kind) {
  case StatementKind::Interrupt: return interrupt(state);
  case StatementKind::If: return sequence({atOnce(), testArms(state)});
  case StatementKind::While:
  case StatementKind::DoUntil: return sequence({atOnce(), testLoop(state)});
  case StatementKind::Choose: return sequence({atOnce(), choose(state)});
  case StatementKind::Break: return sequence({atOnce(), goOn("leaves the loop")});
  case StatementKind::Goto:
    return sequence({atOnce(), goOn("jumps to `" + std::string(statement.name.text) + "`")});
  case StatementKind::Set: {
    const auto words = origin(statement.range, "sets " + quote(statement.effects.range));
    return sequence(
        {at(words, atOnce()), effects(context, actor, statement.effects), to(state.next)});
  }
  case StatementKind::Printf: {
    const auto format = "\"" + std::string(statement.format.text) + "\"";
    const auto words = "prints " + format;
    if (context.isExecuted())
      context.messages.emplace(origin(statement.range, words), messageOf(context, statement));
    return sequence({atOnce(), saying(words, goOn(words))});
  }
  case StatementKind::Success:
  case StatementKind::Failure: return sequence({atOnce(), conclude(statement)});
  case StatementKind::Emit: {
    const auto words = "generates the event `" + std::string(statement.name.text) + "`";
    return sequence(
        {at(origin(statement.range, words), synchronise(context.names.event(statement.name.text))),
         to(state.next)});
  }
  case StatementKind::Unknown:
  case StatementKind::Label:
  case StatementKind::Call:
  case StatementKind::Case:
  case StatementKind::Parallel:
  case StatementKind::Race:
  case StatementKind::WaitCondition:
  case StatementKind::WaitTime: break;
  }
  assert(false && "not a single step");
  return {};
}

// --- Parallel branches

namespace {

bool isRace(const BodyState& state) { return state.statement->kind == StatementKind::Race; }

} // namespace

void BodyProcess::addParallel(fiacre::Process& process, const BodyState& state) {
  const auto place = origin(state.statement->range);
  const auto sync = syncState(state);
  std::vector<Statement> start{atOnce()};
  std::vector<std::string_view> running;
  for (const auto& branch : state.branches) {
    start.push_back(calls.take(branch.name));
    running.emplace_back(branch.name);
  }
  const auto words =
      isRace(state) ? "starts a race of its branches" : "starts its parallel branches";
  start.push_back(at(origin(state.statement->range, words), to(sync)));
  addState(process, state.name, place, unlessHeld(sequence(std::move(start))), lineOf(state));
  addState(process, sync, place, watched(whenItMay(join(state)), abortStatements(running, true)));
}

Statement BodyProcess::join(const BodyState& state) {
  std::vector<fiacre::Expr> done;
  for (const auto& branch : state.branches) done.push_back(calls.isDone(branch.name));
  done.push_back(mayGoOn());
  const auto words = origin(state.statement->range, isRace(state) ? "joins its racing branches"
                                                                  : "joins its parallel branches");
  auto all = conjunction(std::move(done));
  causedBy(context, words, all);
  return sequence({atOnce(), on(std::move(all)), at(words, to(state.next))});
}

// --- Tests

Statement BodyProcess::tested(syntax::Range range, bool value, const std::string& target) {
  const auto words = fmt::format("tests {}: {}", quote(range), value);
  return at(origin(range, words), to(target));
}

/// Evaluates all conditions of an `if` in one transition.
Statement BodyProcess::testArms(const BodyState& state) {
  const auto& arms = state.statement->arms;
  const bool hasElse = !arms.back().condition;
  const auto tests = arms.size() - (hasElse ? 1 : 0);
  const auto& otherwise = hasElse ? state.targets.back() : state.next;
  auto chain = tests == 1 ? tested(arms[0].condition->range, false, otherwise)
                          : at(origin(state.statement->range, "finds all its conditions false"),
                               to(otherwise));
  const auto allFalse = chain.origin;
  for (std::size_t i = tests; i-- > 0;) {
    const auto test = conditionIn(body.name, context, *arms[i].condition);
    decidedBy(context, allFalse, test, false);
    auto passed = tested(arms[i].condition->range, true, state.targets[i]);
    decidedBy(context, passed.origin, test, true);
    chain = ifThenElse(test, std::move(passed), std::move(chain));
  }
  return chain;
}

Statement BodyProcess::testLoop(const BodyState& state) {
  const auto& statement = *state.statement;
  const bool isWhile = statement.kind == StatementKind::While;
  const auto& whenTrue = isWhile ? state.targets[0] : state.next;
  const auto& whenFalse = isWhile ? state.next : state.targets[0];
  const auto test = conditionIn(body.name, context, statement.condition);
  auto passed = tested(statement.condition.range, true, whenTrue);
  auto failed = tested(statement.condition.range, false, whenFalse);
  decidedBy(context, passed.origin, test, true);
  decidedBy(context, failed.origin, test, false);
  return ifThenElse(test, std::move(passed), std::move(failed));
}

Statement BodyProcess::choose(const BodyState& state) {
  std::vector<Statement> choices;
  for (std::size_t i = 0; i < state.targets.size(); ++i)
    choices.push_back(
        at(origin(state.statement->branches[i].range, fmt::format("chooses alternative {}", i + 1)),
           to(state.targets[i])));
  return select(std::move(choices));
}

/// Sets the interrupt flag of a skill that was called, whether or not it runs yet. Has no effect on
/// others.
Statement BodyProcess::interrupt(const BodyState& state) {
  const auto& statement = *state.statement;
  const auto target = statement.name.text;
  const auto* skill = context.plan.find(target);
  const auto nothing = at(origin(statement.range, fmt::format("has nothing to interrupt: `{}` is "
                                                              "not running",
                                                              target)),
                          to(state.next));
  if (!skill || !skill->skill().interrupt) return sequence({atOnce(), nothing});
  causedBy(context, nothing.origin, calls.isOutstanding(target));
  const auto words = origin(statement.range, fmt::format("interrupts `{}`", target));
  auto raise = sequence(
      {at(words, assign(context.cellField(target, "stop"), boolean(true))), to(state.next)});
  return sequence({atOnce(), ifThenElse(calls.isOutstanding(target), std::move(raise), nothing)});
}

const std::string& processOf(Context& context, const SkillPlan& skill,
                             const BodyAutomaton& thread) {
  if (thread.path.empty()) return context.names.process({"skill", skill.name()});
  constexpr std::string_view kInfix = "_branch_";
  // `1_0` of `uav_mission_branch_1_0`
  const auto numbers = std::string_view(thread.name).substr(skill.name().size() + kInfix.size());
  return context.names.process({"skill_branch", skill.name(), numbers});
}

std::vector<std::string> statesOf(const Context& context, const BodyState& state) {
  std::vector<std::string> states{state.name};
  if (!state.statement) return states;
  const bool calls = state.statement->kind == StatementKind::Call;
  if (calls && context.plan.find(state.statement->head.text)->shared())
    states.push_back(busyState(state));
  if (calls || syntax::runsBranches(*state.statement)) states.push_back(syncState(state));
  return states;
}

} // namespace proskill::codegen
