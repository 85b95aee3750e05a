#pragma once

#include "fiacre/provenance.h"
#include "verify/verify.h"

namespace proskill::ide {

/// The trace without steps of the model that are none of the program: those in which a skill that
/// has ended stays so.
[[nodiscard]] verify::Trace withoutIdleSteps(verify::Trace trace,
                                             const fiacre::Provenance& provenance);

} // namespace proskill::ide
