#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The process of a basic skill. In models to verify its action ends at any date in its time
/// interval with any of its outcomes. The expanded edition names every state. At runtime the action
/// is a task.
[[nodiscard]] fiacre::Process basicSkill(Context& context, const SkillPlan& skill);

} // namespace proskill::codegen
