#pragma once

#include "bridge/text/form.h"

namespace proskill::bridge::bt {

/// Replaces the conditions of tests and waits whose value is known, by the flow analysis of the
/// program, by `true` and `false`. \return whether there were any
bool decideTests(Block& program);

} // namespace proskill::bridge::bt
