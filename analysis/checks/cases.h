#pragma once

#include "analysis/names/names.h"

namespace proskill::analysis {

/// The arms of a `case` in a body: names of outcomes, and whether every outcome of the call has
/// one.
void checkCase(Context& context, const Body& body, const syntax::Statement& statement);

} // namespace proskill::analysis
