#pragma once

#include "verify/slice/slicer.h"
#include "verify/trace/dates.h"

#include <optional>

namespace proskill::verify {

/// A run of the whole system in which the steps of a run of a slice happen at their dates. Other
/// steps are put in where time would not pass without them, as late as possible. Nothing where that
/// does not work out: the run may be one of the slice alone.
/// \param whole the system with every cell kept \param dating of the steps in the slice
/// \throw LimitMet
[[nodiscard]] std::optional<Steps> wholeRun(const System& whole, const Slice& slice,
                                            const Steps& steps, const Dating& dating,
                                            LimitWatch& limits);

} // namespace proskill::verify
