#pragma once

#include "tests/meaning/runs.h"

#include <functional>

namespace proskill::meaning {

/// Whether a condition is true of a situation and the step that leaves it.
using Seen = std::function<bool(const syntax::Expr&, const Situation&, const std::vector<Fact>&)>;

/// Whether a formula of linear temporal logic holds in all runs that count, over situations with
/// the step that leaves them; the last one of a run that rests is repeated for ever. A run that
/// violates it is looked for with the formulas that it still has to make true: Wolper, "The tableau
/// method for temporal logic" (1985). Nothing for formulas with `()`, since steps are not those of
/// the translation, and where there is too much to look at.
[[nodiscard]] std::optional<bool> holdsInRuns(const syntax::Property& property,
                                              const Script& script, const Runs& runs,
                                              const Seen& seen);

} // namespace proskill::meaning
