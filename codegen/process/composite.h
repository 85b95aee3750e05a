#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The processes of a composite skill: its body, its parallel branches in the order of the text,
/// and its watchdog where it has a time interval.
[[nodiscard]] std::vector<fiacre::Process> compositeSkill(Context& context, const SkillPlan& skill);

} // namespace proskill::codegen
