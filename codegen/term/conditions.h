#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// A condition of the program, without the atoms of properties. \pre it has no errors
[[nodiscard]] fiacre::Expr condition(Context& context, const syntax::Expr& expr);
/// The same as the body `reader` sees it: with the outcomes of its own calls.
[[nodiscard]] fiacre::Expr conditionIn(std::string_view reader, Context& context,
                                       const syntax::Expr& expr);

/// The condition that `variable` has `value`, as in `(battery Low)`.
[[nodiscard]] fiacre::Expr hasValue(Context& context, const syntax::Name& variable,
                                    const syntax::Expr& value);

/// The right-hand side of an assignment to an enumeration or of a comparison with it: a value or a
/// variable.
[[nodiscard]] fiacre::Expr enumerationValue(Context& context, std::string_view variable,
                                            std::string_view word);

/// The conjunction of all preconditions of a skill.
[[nodiscard]] fiacre::Expr precondition(Context& context, const syntax::Skill& skill);

} // namespace proskill::codegen
