#pragma once

#include "verify/slice/slicer.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// Divides the urgent steps that may repeat without time passing into groups that do not influence
/// each other. If time can always go on in the slice of each group, it can in the whole:
/// docs/verification.md argues why.
/// \param whole the slicer's system with every cell kept
/// \return the seeds of an exact slice for each group; nothing if they cannot be judged apart
/// \throw LimitMet
[[nodiscard]] std::optional<std::vector<SliceSeeds>>
recurrentParts(const System& whole, Slicer& slicer, LimitWatch& limits);

} // namespace proskill::verify
