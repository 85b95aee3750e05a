#pragma once

#include "fiacre/provenance.h"
#include "verify/model/system.h"

#include <vector>

namespace proskill::verify {

/// What started instances wait for in a deadlock: for each, the origin of its next step. Instances
/// that wait for a condition come before instances that wait for others. \param state in which no
/// step is possible
[[nodiscard]] std::vector<fiacre::OriginId>
waitsIn(const System& system, const fiacre::Provenance& provenance, const std::vector<Word>& state);

} // namespace proskill::verify
