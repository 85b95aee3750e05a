#pragma once

#include "codegen/model.h"

#include <string>
#include <vector>

namespace proskill::ide {

/// "`left` waits for `(door Open)`; `m` waits until `drive` returns": what each of these origins is
/// the next step of. Empty where there are none.
[[nodiscard]] std::string waitsText(const std::vector<fiacre::OriginId>& waits,
                                    const codegen::Model& model);

} // namespace proskill::ide
