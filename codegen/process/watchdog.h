#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The process that sees whether a composite skill takes too little or too much time: exact at the
/// bounds offline, to a tick at runtime. \pre the skill has a time interval.
[[nodiscard]] fiacre::Process watchdog(Context& context, const SkillPlan& skill);

} // namespace proskill::codegen
