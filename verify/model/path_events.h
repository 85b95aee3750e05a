#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// The events that may happen on some paths.
[[nodiscard]] inline Bits eventsOf(const System& system, const std::vector<PathId>& paths) {
  Bits all;
  for (auto id : paths)
    for (const auto& instruction : system.paths[id].code)
      if (instruction.event != kNone) all.insert(instruction.event);
  return all;
}

} // namespace proskill::verify
