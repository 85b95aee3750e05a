#include "analysis/checks/checks.h"
#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"

namespace proskill::analysis {

using syntax::Code;
using syntax::Name;
using syntax::StatementKind;

namespace {

/// `(= skill.res no_result)` asks whether there is a result at all.
void checkTag(Context& context, const Definition<syntax::Skill>& skill, const Name& tag) {
  if (tag.text != kNoResult) return;
  context.findings.report(Code::ReservedTag, skill.at(tag.range), tag.text)
      .fix("call it `no_tag`", skill.at(tag.range), "no_tag");
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
  context.each(context.program.skills, [&](const auto& skill) { checkTags(context, skill); });
}

} // namespace proskill::analysis
