#pragma once

#include "tests/meaning/endless/ltl.h"

namespace proskill::meaning {

[[nodiscard]] bool hasScopeOrTime(const syntax::Property& property);

/// Whether a pattern with a scope or a time is true of all runs, as the table of patterns in
/// docs/fiacre.md says: by looking at situations and steps one by one, with a watch that shows how
/// long it is since the pattern began to count. Where a run without end may be what violates it,
/// only fair runs count. Nothing where the pattern has no meaning, and where there is too much to
/// look at.
[[nodiscard]] std::optional<bool> isTrueInTime(const syntax::Property& property,
                                               const Script& script, const Seen& seen);

} // namespace proskill::meaning
