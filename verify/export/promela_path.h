#pragma once

#include "verify/export/promela_model.h"

namespace proskill::verify {

/// The code of a part of a transition, one statement each. Where it fails it jumps to the label
/// `E` with the number of the transition.
[[nodiscard]] std::vector<std::string> promelaPath(PromelaModel& model, TransitionId id,
                                                   std::size_t part);

} // namespace proskill::verify
