#pragma once

#include "codegen/property/observe.h"

namespace proskill::codegen {

/// A property of the program as a Fiacre pattern, with times in units. `(reachable P)` and `(never
/// P)` both become `absent P`.
[[nodiscard]] fiacre::Pattern patternOf(Context& context, Observer& observer,
                                        const syntax::Property& property);

} // namespace proskill::codegen
