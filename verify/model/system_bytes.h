#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// The bytes that a copy of the system needs, at least: those of its paths, transitions and nodes,
/// without what the allocator adds.
[[nodiscard]] std::uint64_t bytesOf(const System& system);

} // namespace proskill::verify
