#include "codegen/process/body_process.h"

#include "codegen/term/conditions.h"
#include "codegen/term/grounds.h"
#include "codegen/term/inputs.h"

#include <fmt/format.h>

/// Calls of skills from a body, and their returns.
namespace proskill::codegen {

using fiacre::Statement;

void BodyProcess::addCall(fiacre::Process& process, const BodyState& state) {
  const auto& callee = *context.plan.find(state.statement->head.text);
  const auto place = origin(state.statement->range);
  const auto sync = syncState(state);
  if (!callee.shared()) {
    addState(process, state.name, place, unlessHeld(sequence({atOnce(), callNow(state, sync)})),
             lineOf(state));
  } else {
    const auto busy = busyState(state);
    const auto isFree = calls.isFree(callee.name());
    const auto words = fmt::format("finds `{}` busy", callee.name());
    auto findBusy = sequence({at(causedBy(context, origin(state.statement->range, words), isFree),
                                 tag(context.names.tag({body.name, state.name, "busy"}))),
                              to(busy)});
    addState(process, state.name, place,
             unlessHeld(sequence(
                 {atOnce(), ifThenElse(isFree, callNow(state, sync), std::move(findBusy))})),
             lineOf(state));
    addState(process, busy, place,
             watched(whenItMay(sequence({atOnce(), on(isFree), callNow(state, sync)})),
                     abortStatements({}, false)));
  }
  addState(
      process, sync, place,
      watched(whenItMay(sequence({atOnce(), on(calls.isDone(callee.name())), returnFrom(state)})),
              abortStatements({callee.name()}, false)));
}

Statement BodyProcess::callNow(const BodyState& state, const std::string& sync) {
  const auto& statement = *state.statement;
  const auto callee = statement.head.text;
  const auto words = fmt::format("calls `{}`", callee);
  std::vector<Statement> all{at(origin(statement.range, words), calls.take(callee)),
                             setInputs(context, *context.plan.find(callee), statement),
                             keepOutcome(callee)};
  if (context.isPerformed())
    all.push_back(saying("synthesized action arg index",
                         assign(context.cellField(callee, "ArgIndex"), argumentsOf(statement))));
  all.push_back(to(sync));
  return sequence(std::move(all));
}

/// The number of the call's arguments; it depends on the caller's own number if they contain its
/// parameters.
fiacre::Expr BodyProcess::argumentsOf(const syntax::Statement& call) {
  const auto& numbers = context.arguments.numbersOf(call);
  if (numbers.empty()) return number(0); // the call is unreachable
  auto chosen = number(numbers.rbegin()->second);
  for (const auto& [own, reached] : numbers) {
    if (number(reached) == chosen) continue;
    const auto ofCaller = context.cellField(context.arguments.callerOf(call), "ArgIndex");
    chosen = conditional(equal(ofCaller, number(own)), number(reached), std::move(chosen));
  }
  return chosen;
}

/// Copies the outcome of a skill that others call, too. This body and those around it then know the
/// outcome of their own call.
Statement BodyProcess::keepOutcome(std::string_view callee) {
  std::vector<Statement> all;
  eachOutcomeField(callee, [&](const fiacre::Expr& own, fiacre::Expr last) {
    all.push_back(assign(own, std::move(last)));
  });
  return sequence(std::move(all));
}

Statement BodyProcess::keepOutcomeOfStopped(std::string_view callee) {
  std::vector<Statement> all;
  eachOutcomeField(callee, [&](const fiacre::Expr& own, fiacre::Expr last) {
    all.push_back(assign(own, conditional(calls.isMine(callee), std::move(last), own)));
  });
  return sequence(std::move(all));
}

/// Calls `visit(own, last)` with the copy and the skill's own field.
void BodyProcess::eachOutcomeField(
    std::string_view callee, const std::function<void(const fiacre::Expr&, fiacre::Expr)>& visit) {
  for (const auto thread : context.plan.ownOutcomes.toldBy(body.name, callee)) {
    const auto& kept = context.plan.ownOutcomes.of(thread, callee);
    const auto keep = [&](std::string_view field) {
      visit(context.ownField(thread, callee, field), context.cellField(callee, field));
    };
    if (kept.status) keep("status");
    if (kept.result) keep("val");
  }
}

Statement BodyProcess::returnFrom(const BodyState& state) {
  const auto& callee = *context.plan.find(state.statement->head.text);
  auto acknowledge = sequence({keepOutcome(callee.name()), calls.acknowledge(callee.name())});
  auto next = state.cases ? chooseArm(state, callee)
                          : goOnAfter(state, callee, state.statement->range, state.next);
  return sequence({std::move(acknowledge), std::move(next)});
}

Statement BodyProcess::goOnAfter(const BodyState& state, const SkillPlan& callee,
                                 syntax::Range range, const std::string& target) {
  const auto isDone = calls.isDone(callee.name());
  const auto returns = origin(range, fmt::format("continues after `{}`", callee.name()));
  auto goOn = at(causedBy(context, returns, isDone), to(target));
  if (isTrue(precondition(context, callee))) return goOn;
  const auto words = origin(range, fmt::format("notices that `{}` was refused", callee.name()));
  causedBy(context, words, isDone);
  auto refused =
      sequence({tag(context.names.tag({body.name, state.name, "refused"})), at(words, to(target))});
  return ifThenElse(equal(context.cellField(callee.name(), "status"), name("no_status")),
                    std::move(refused), std::move(goOn));
}

/// Chooses the arm in the step in which the call returns. `check` demands an arm for each outcome,
/// so the last one needs no test.
Statement BodyProcess::chooseArm(const BodyState& state, const SkillPlan& callee) {
  const auto& arms = state.cases->arms;
  Statement chosen;
  for (std::size_t i = arms.size(); i-- > 0;) {
    const auto& [status, tags, range] = arms[i].pattern;
    const auto words = fmt::format("continues after `{}` with {}", callee.name(), quote(range));
    const bool mayBeRefused = status.text == "refused" || !arms[i].condition;
    auto take = mayBeRefused
                    ? goOnAfter(state, callee, range, state.targets[i])
                    : at(causedBy(context, origin(range, words), calls.isDone(callee.name())),
                         to(state.targets[i]));
    const bool isLast = i + 1 == arms.size() || !arms[i].condition;
    chosen = isLast ? std::move(take)
                    : ifThenElse(condition(context, *arms[i].condition), std::move(take),
                                 std::move(chosen));
  }
  return chosen;
}

} // namespace proskill::codegen
