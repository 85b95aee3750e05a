#pragma once

#include "verify/trace/dates.h"

#include <optional>

namespace proskill::verify {

/// A run of the whole system in which the steps of a slice's run happen at their dates. Adds other
/// steps if time could not pass without them, as late as possible.
/// \return nullopt if this fails: the run may exist in the slice only
/// \param whole the system with every cell kept
/// \param steps of the run, in the whole
/// \param planned transitions of the whole that are not added
/// \param dating of the steps in the slice
/// \throw LimitMet
[[nodiscard]] std::optional<Steps> wholeRun(const System& whole, const Steps& steps,
                                            const Bits& planned, const Dating& dating,
                                            LimitWatch& limits);

} // namespace proskill::verify
