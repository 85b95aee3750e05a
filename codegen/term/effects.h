#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// Effects, all at once: moves that are not allowed raise their alarm, then every variable gets a
/// value that is read before any is written.
[[nodiscard]] fiacre::Statement effects(Context& context, const Actor& actor,
                                        const syntax::Effects& effects);

/// The move from one value of an enumeration to another is allowed. Staying always is.
[[nodiscard]] bool isAllowed(const syntax::StateVariable& variable, std::string_view from,
                             std::string_view to);

} // namespace proskill::codegen
