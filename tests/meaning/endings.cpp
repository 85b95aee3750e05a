#include "tests/meaning/endings.h"

namespace proskill::meaning {
namespace {

Ending declared(Status status, const syntax::Outcome& outcome) {
  Ending ending{.outcome = {status, outcome.tag.text}, .at = outcome.range.begin};
  ending.effects = &outcome.effects;
  if (!outcome.postcondition) return ending;
  ending.postcondition = &*outcome.postcondition;
  ending.postconditionAt = outcome.postcondition->range.begin;
  return ending;
}

} // namespace

Ending plainSuccess(const syntax::Skill& skill) {
  return {.outcome = {Status::Success}, .at = skill.name.range.begin};
}

std::vector<Ending> outcomesOf(const syntax::Skill& skill) {
  std::vector<Ending> all;
  for (const auto& outcome : skill.successes) all.push_back(declared(Status::Success, outcome));
  if (all.empty()) all.push_back(plainSuccess(skill));
  for (const auto& outcome : skill.failures) all.push_back(declared(Status::Failure, outcome));
  return all;
}

Ending endingOf(const syntax::Skill& skill, const syntax::Statement& statement) {
  const bool succeeds = statement.kind == syntax::StatementKind::Success;
  for (const auto& outcome : succeeds ? skill.successes : skill.failures)
    if (outcome.tag.text == statement.name.text)
      return declared(succeeds ? Status::Success : Status::Failure, outcome);
  return plainSuccess(skill);
}

Ending interruptionOf(const syntax::Skill& skill) {
  Ending ending{.outcome = {Status::Interrupted}, .at = skill.name.range.begin};
  if (!skill.interrupt) return ending;
  ending.effects = &skill.interrupt->effects;
  ending.at = skill.interrupt->range.begin;
  return ending;
}

Ending failureOf(const syntax::Invariant& invariant) {
  return {.outcome = {Status::FailedInvariant, invariant.tag.text},
          .effects = &invariant.effects,
          .at = invariant.range.begin};
}

} // namespace proskill::meaning
