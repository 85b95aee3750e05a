#pragma once

#include "bridge/text/form.h"

namespace proskill::bridge::bt {

/// Null if the definition is not a composite skill, which ends with its body.
[[nodiscard]] const Form* bodyOf(const Form& definition);

/// Declares the outcomes that the bodies of composite skills have, and no others. Replaces what
/// compares a skill with another outcome by `true` or `false`. \return whether there was any
bool declareOutcomes(Block& program);

} // namespace proskill::bridge::bt
