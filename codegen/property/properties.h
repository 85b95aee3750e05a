#pragma once

#include "codegen/property/observe.h"

namespace proskill::codegen {

/// A property that the program states itself, as a pattern of Fiacre with its times in units.
/// `(reachable P)` and `(never P)` are both `absent P`.
[[nodiscard]] fiacre::Pattern patternOf(Context& context, Observer& observer,
                                        const syntax::Property& property);

} // namespace proskill::codegen
