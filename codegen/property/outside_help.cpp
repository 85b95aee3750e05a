#include "codegen/property/outside_help.h"

#include "codegen/plan/flow.h"
#include "syntax/text/quote.h"
#include "syntax/tree/statements.h"

#include <algorithm>
#include <utility>

namespace proskill::codegen {
namespace {

using syntax::StatementKind;

/// Whether a body gets past the statement by itself, now or after some time.
bool goesOnByItself(const Context& context, const syntax::Statement& statement) {
  switch (statement.kind) {
  case StatementKind::Interrupt:
  case StatementKind::WaitTime:
  case StatementKind::If:
  case StatementKind::While:
  case StatementKind::DoUntil:
  case StatementKind::Break:
  case StatementKind::Label:
  case StatementKind::Goto:
  case StatementKind::Set:
  case StatementKind::Printf:
  case StatementKind::Choose: return true;
  case StatementKind::WaitCondition: return syntax::hasTimeout(statement);
  case StatementKind::Emit: return !context.program.events.find(statement.name.text)->node().guard;
  case StatementKind::Unknown:
  case StatementKind::Call:
  case StatementKind::Case:
  case StatementKind::Parallel:
  case StatementKind::Race:
  case StatementKind::Success:
  case StatementKind::Failure: return false;
  }
  std::unreachable();
}

/// Whether the body makes steps for ever, whatever the others do.
bool goesOnForEver(const Context& context, const BodyAutomaton& body) {
  const auto reached = statesOnPaths(body);
  return std::ranges::all_of(body.states, [&](const BodyState& state) {
    if (!reached.contains(state.name)) return true;
    return state.statement && goesOnByItself(context, *state.statement);
  });
}

/// Nothing refuses, ends or delays the monitor.
bool isFree(const syntax::Skill& monitor) {
  return monitor.preconditions.empty() && monitor.invariants.empty() && !monitor.interrupt &&
         monitor.resources.empty();
}

} // namespace

std::string alwaysPossible(const Context& context) {
  const auto* mission = context.plan.mission;
  if (!mission) return "";
  const bool isOpen = !context.plan.environment;
  for (const auto& event : context.program.events.all)
    if (event->every || (isOpen && !event->guard))
      return syntax::backquoted(event.name()) + " can always occur";
  for (const auto& skill : context.plan.skills)
    if (isOpen && skill.skill().interrupt && (&skill == mission || skill.rearms()))
      return syntax::backquoted(skill.name()) + " can always be interrupted";
  if (!isOpen && goesOnForEver(context, *context.plan.environmentBody))
    return "the environment always goes on";
  for (const auto& skill : context.plan.skills)
    if (skill.root && &skill != mission && skill.body && isFree(skill.skill()) &&
        goesOnForEver(context, *skill.body))
      return syntax::backquoted(skill.name()) + " always goes on";
  return "";
}

} // namespace proskill::codegen
