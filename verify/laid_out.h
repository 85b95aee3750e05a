#pragma once

#include "verify/limits.h"
#include "verify/model/system.h"

namespace proskill::verify {

/// A copy of a system. \throw LimitMet if the copy would exceed the memory limit
[[nodiscard]] System checkedCopy(const System& whole, LimitWatch& limits);
/// A copy of a system with a layout of its states. \throw LimitMet if the copy would exceed the
/// memory limit
[[nodiscard]] System laidOutCopy(const System& whole, LimitWatch& limits);
/// The same with a layout of only some cells.
[[nodiscard]] System laidOutCopy(const System& whole, const Bits& kept, LimitWatch& limits);

} // namespace proskill::verify
