#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// A condition of the program, without the atoms of properties. \pre it has no errors
[[nodiscard]] fiacre::Expr condition(Context& context, const syntax::Expr& expr);
/// The same as the body `reader` sees it: with the outcomes of its own calls.
[[nodiscard]] fiacre::Expr conditionIn(std::string_view reader, Context& context,
                                       const syntax::Expr& expr);

/// The right-hand side of an assignment to an enumeration or of a comparison with it: a value, a
/// variable, or an input.
[[nodiscard]] fiacre::Expr enumerationValue(Context& context, const syntax::StateVariable& type,
                                            const syntax::Expr& value);

/// The conjunction of all preconditions of a skill.
[[nodiscard]] fiacre::Expr precondition(Context& context, const SkillPlan& skill);

} // namespace proskill::codegen
