#pragma once

#include "tests/meaning/endless/ltl.h"

namespace proskill::meaning {

[[nodiscard]] bool hasScopeOrTime(const syntax::Property& property);

/// Whether a pattern with a scope or a time is true of all runs, according to the table of patterns
/// in docs/fiacre.md. Examines situations and steps one by one, with a watch that shows the time
/// since the pattern started to count. If an infinite run violates it, only fair runs count.
/// nullopt if the pattern has no meaning, or there are too many situations.
[[nodiscard]] std::optional<bool> isTrueInTime(const syntax::Property& property,
                                               const Script& script, const Seen& seen);

} // namespace proskill::meaning
