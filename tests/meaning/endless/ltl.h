#pragma once

#include "tests/meaning/runs.h"

#include <functional>

namespace proskill::meaning {

/// Whether a condition is true of a situation and the step that leaves it.
using Seen = std::function<bool(const syntax::Expr&, const Situation&, const std::vector<Fact>&)>;

/// Whether a formula of linear temporal logic is true of all counted runs, as sequences of
/// situations and steps; the last situation of a finite run is repeated for ever. Searches for a
/// violation with a tableau: Wolper, "The tableau method for temporal logic" (1985). nullopt for
/// formulas with `()` where the translation makes other steps, and for too many situations.
[[nodiscard]] std::optional<bool> holdsInRuns(const syntax::Property& property,
                                              const Script& script, const Runs& runs,
                                              const Seen& seen);

} // namespace proskill::meaning
