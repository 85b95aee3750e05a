#pragma once

#include "verify/system.h"

#include <map>

namespace proskill::verify {

/// What is surely written on every way through a path's code to an end, by target; the location
/// itself for `loop`.
[[nodiscard]] std::map<std::uint32_t, Bits> surelyWritten(const Path& path, const Bits& allCells);

} // namespace proskill::verify
