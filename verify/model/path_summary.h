#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// Adds what the guard and the code of a path read and write, and whether it may fail.
void summarisePath(const System& system, Path& path);

} // namespace proskill::verify
