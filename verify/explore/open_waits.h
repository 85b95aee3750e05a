#pragma once

#include "verify/model/system.h"

#include <set>
#include <string>
#include <vector>

namespace proskill::verify {

/// Locations in which a process waits, without an upper bound, for a step that it can take alone;
/// for example the end of an action that may take any time. A fair run does not stay there for
/// ever.
struct OpenWait {
  InstanceId instance = 0;
  Bits locations;
};

/// The open waits of the given processes. Steps that depend on other processes do not count.
[[nodiscard]] std::vector<OpenWait>
openWaits(const System& system, const std::set<std::string>& processes, const Bits& dropped);

[[nodiscard]] bool isWaiting(const System& system, const OpenWait& wait, const Word* state);

} // namespace proskill::verify
