#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// Inputs of skills that conditions or effects read. Each is a variable of the model, which a call
/// sets in the step in which it is made.

/// Gives the callee's inputs the arguments of a call.
[[nodiscard]] fiacre::Statement setInputs(Context& context, const SkillPlan& callee,
                                          const syntax::Statement& call);
/// Gives them any values, for the most general caller.
[[nodiscard]] fiacre::Statement chooseInputs(Context& context, const SkillPlan& callee);
/// The name by which traces show an input, given with its `$`: `go.to`.
[[nodiscard]] std::string shownInput(std::string_view skill, std::string_view input);
/// The variables of all skills, with their first values.
[[nodiscard]] std::vector<fiacre::Variable> inputVariables(Context& context);

} // namespace proskill::codegen
