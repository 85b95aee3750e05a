#pragma once

#include "analysis/names/names.h"

namespace proskill::analysis {

/// Checks the arms of a `case`: names of outcomes, and whether every outcome of the call is
/// covered.
void checkCase(Context& context, const Body& body, const syntax::Statement& statement);

} // namespace proskill::analysis
