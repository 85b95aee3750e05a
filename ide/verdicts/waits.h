#pragma once

#include "codegen/model.h"

#include <string>
#include <vector>

namespace proskill::ide {

/// "`left` waits for `(door Open)`; `m` waits for the end of `drive`": the next steps with these
/// origins. Empty if there are none.
[[nodiscard]] std::string waitsText(const std::vector<fiacre::OriginId>& waits,
                                    const codegen::Model& model);

} // namespace proskill::ide
