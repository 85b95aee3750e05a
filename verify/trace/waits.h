#pragma once

#include "fiacre/provenance.h"
#include "verify/model/system.h"
#include "verify/verify.h"

#include <vector>

namespace proskill::verify {

/// What instances wait for in a deadlock. Those that are called but cannot start come first, then
/// those that wait for a condition, then those that wait for others.
/// \param state in which no step is possible
[[nodiscard]] std::vector<Wait> waitsIn(const System& system, const fiacre::Provenance& provenance,
                                        const std::vector<Word>& state);

} // namespace proskill::verify
