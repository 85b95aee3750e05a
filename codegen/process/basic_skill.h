#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The process of a basic skill. Offline its action ends at any date in its time interval, with any
/// of its outcomes; expanded the same, with every state named; at runtime a task is the action.
[[nodiscard]] fiacre::Process basicSkill(Context& context, const SkillPlan& skill);

} // namespace proskill::codegen
