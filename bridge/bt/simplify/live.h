#pragma once

#include "bridge/text/form.h"

namespace proskill::bridge::bt {

/// The statements of a body that can be reached, without labels to which nothing jumps. Tests and
/// waits whose condition is the word `true` or `false` are decided.
[[nodiscard]] Block liveStatements(const Block& body);

} // namespace proskill::bridge::bt
