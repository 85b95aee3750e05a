#include "analysis/checks/checks.h"
#include "syntax/diagnostics/codes.h"

namespace proskill::analysis {

namespace {

void checkInputs(Context& context, const Definition<syntax::Skill>& skill) {
  if (skill->inputs.empty()) return;
  context.findings.report(syntax::Code::InputsAtStart, skill.at(skill->inputs.front().name.range),
                          skill.name());
}

} // namespace

/// A skill that starts with the program has no caller to pass arguments.
void checkStart(Context& context) {
  for (const auto& skill : context.program.skills.all)
    if (skill.nodeAsRead().monitor) checkInputs(context, skill);
  if (context.program.extent == Extent::Fragment) return;
  if (const auto* main = mainSkill(context.program, context.calls).skill)
    checkInputs(context, *main);
}

} // namespace proskill::analysis
