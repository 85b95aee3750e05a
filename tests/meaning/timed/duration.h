#pragma once

#include "tests/meaning/endless/ltl.h"

#include "verify/verify.h"

namespace proskill::meaning {

/// Times up to this one, in units, are distinguished.
inline constexpr std::int64_t kMeasured = 6;

/// The longest or the shortest time from the first condition of a property to the next second one,
/// in units. `bounded` is false if it is longer than kMeasured. nullopt if there are too many
/// situations.
[[nodiscard]] std::optional<verify::Duration> durationOf(const syntax::Property& property,
                                                         const Script& script, const Seen& seen);

} // namespace proskill::meaning
