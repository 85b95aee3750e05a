#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// Simultaneous effects. First, forbidden moves raise their alarms. Then all values are computed
/// before any variable is written.
[[nodiscard]] fiacre::Statement effects(Context& context, const Actor& actor,
                                        const syntax::Effects& effects);

/// Whether the move between two values of an enumeration is allowed. Keeping the value always is.
[[nodiscard]] bool isAllowed(const syntax::StateVariable& variable, std::string_view from,
                             std::string_view to);

} // namespace proskill::codegen
