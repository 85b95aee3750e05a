#pragma once

#include "host/connection.h"

#include <string>

namespace proskill::host {

/// Makes a crash of this thread report the action of a skill, or the library if `skill` is empty,
/// so that the recording contains it.
void nameInCrashes(const std::string& skill, const Connection& connection);

} // namespace proskill::host
