#pragma once

#include "analysis/program/program.h"
#include "bridge/text/place.h"

namespace proskill::bridge {

/// The place where something of a program begins.
[[nodiscard]] Place placeOf(const analysis::Program& program, analysis::Location location);

} // namespace proskill::bridge
