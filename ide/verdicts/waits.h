#pragma once

#include "codegen/model.h"
#include "verify/verify.h"

#include <string>
#include <vector>

namespace proskill::ide {

/// "`drive` waits for the resource `wheels`, which `brush` has; `left` waits for `(door Open)`; `m`
/// waits for the end of `drive`". Empty if there are no waits.
[[nodiscard]] std::string waitsText(const std::vector<verify::Wait>& waits,
                                    const codegen::Model& model);

} // namespace proskill::ide
