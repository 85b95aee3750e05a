#pragma once

#include "host/connection.h"

#include <string>

namespace proskill::host {

/// Says what crashes where this thread does: the action of a skill, or where it is empty the
/// library. The recording then has it.
void nameInCrashes(const std::string& skill, const Connection& connection);

} // namespace proskill::host
