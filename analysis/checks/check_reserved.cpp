#include "analysis/checks/checks.h"
#include "analysis/names/names.h"
#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>

namespace proskill::analysis {

using syntax::Code;
using syntax::Name;
using syntax::StatementKind;

namespace {

bool isTruth(std::string_view word) { return word == "true" || word == "false"; }

Finding refuse(Context& context, std::string_view what, const Name& name, Location at) {
  return context.findings.report(Code::ReservedName, at, what, name.text);
}

/// `(= skill.res no_result)` tests whether there is a result.
void checkTag(Context& context, const Definition<syntax::Skill>& skill, const Name& tag) {
  const Location at = skill.at(tag.range);
  if (isTruth(tag.text)) refuse(context, "tag", tag, at);
  if (tag.text == kNoResult) refuse(context, "tag", tag, at).fix("call it `no_tag`", at, "no_tag");
}

/// In a condition these words are truth values, even if something else has the same name.
void checkVariable(Context& context, const Definition<syntax::StateVariable>& variable) {
  if (isTruth(variable->name.text))
    refuse(context, "state variable", variable->name, variable.at(variable->name.range));
  for (const Name& value : variable->states)
    if (isTruth(value.text)) refuse(context, "value", value, variable.at(value.range));
}

/// Next to `skill.status` or `skill.res`, these words are not numbers.
void checkConstant(Context& context, const Definition<syntax::Constant>& constant) {
  const std::string_view name = constant.name();
  if (isTruth(name) || name == kNoResult || std::ranges::count(statusWords(), name) > 0)
    refuse(context, "constant", constant->name, constant.at(constant->name.range));
}

/// `(goto x)` is a statement, so a skill called `goto` could not be called.
void checkSkill(Context& context, const Definition<syntax::Skill>& skill) {
  if (std::ranges::count(statementWords(), skill.name()) > 0)
    refuse(context, "skill", skill->name, skill.at(skill->name.range));
}

void checkTags(Context& context, const Definition<syntax::Skill>& skill) {
  for (const auto& outcome : skill->successes) checkTag(context, skill, outcome.tag);
  for (const auto& outcome : skill->failures) checkTag(context, skill, outcome.tag);
  for (const auto& invariant : skill->invariants) checkTag(context, skill, invariant.tag);
  if (!skill->body) return;
  forEachStatement(*skill->body, [&](const syntax::Statement& statement) {
    if (statement.kind == StatementKind::Success || statement.kind == StatementKind::Failure)
      checkTag(context, skill, statement.name);
  });
}

} // namespace

void checkReserved(Context& context) {
  context.each(context.program.constants,
               [&](const auto& constant) { checkConstant(context, constant); });
  context.each(context.program.stateVariables,
               [&](const auto& variable) { checkVariable(context, variable); });
  context.each(context.program.skills, [&](const auto& skill) {
    checkSkill(context, skill);
    checkTags(context, skill);
  });
}

} // namespace proskill::analysis
