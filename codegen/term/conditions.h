#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// A condition of the program, without the atoms of properties. \pre it has no errors.
[[nodiscard]] fiacre::Expr condition(Context& context, const syntax::Expr& expr);
/// The same as the body `reader` sees it, which has outcomes of its own calls.
[[nodiscard]] fiacre::Expr conditionIn(std::string_view reader, Context& context,
                                       const syntax::Expr& expr);

/// `variable` has `value`, as in `(battery Low)`.
[[nodiscard]] fiacre::Expr hasValue(Context& context, const syntax::Name& variable,
                                    const syntax::Expr& value);

/// What an enumeration is set to or compared with: one of its values, or a variable.
[[nodiscard]] fiacre::Expr enumerationValue(Context& context, std::string_view variable,
                                            std::string_view word);

/// All preconditions of a skill at once.
[[nodiscard]] fiacre::Expr precondition(Context& context, const syntax::Skill& skill);

} // namespace proskill::codegen
