#pragma once

#include "bridge/rl/translate.h"

namespace proskill::bridge::rl {

/// Adds composites to the program of their skillsets. Each becomes a composite skill that succeeds
/// or fails; docs/import.md says what the operators mean.
void addComposites(Translation& to, const std::vector<Skillset>& skillsets,
                   const std::vector<Composite>& composites);

} // namespace proskill::bridge::rl
