#pragma once

#include "fiacre/provenance.h"
#include "verify/model/system.h"

#include <vector>

namespace proskill::verify {

/// What the instances wait for that have begun something and cannot go on: for each, the origin of
/// the step that it would take next. Those that wait for a condition come first, before those that
/// wait for others. \param state in which nothing is possible
[[nodiscard]] std::vector<fiacre::OriginId>
waitsIn(const System& system, const fiacre::Provenance& provenance, const std::vector<Word>& state);

} // namespace proskill::verify
