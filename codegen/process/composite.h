#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The processes of a composite skill: its body, its parallel branches in the order of the text,
/// and its watchdog if it has a time interval.
[[nodiscard]] std::vector<fiacre::Process> compositeSkill(Context& context, const SkillPlan& skill);

/// The process that detects that a composite skill takes too little or too much time. In models to
/// verify it is exact at the bounds, at runtime within a tick. \pre the skill has a time interval
[[nodiscard]] fiacre::Process watchdog(Context& context, const SkillPlan& skill);

} // namespace proskill::codegen
