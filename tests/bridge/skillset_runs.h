#pragma once

#include "bridge/rl/read/skillset.h"

#include <set>

namespace proskill::test {

/// What can be observed of the runs of a skillset in which any skill may be called at any time: a
/// resource that has a state (`r0 S1`), a skill that runs (`running k0`), and a skill that has
/// ended in some way (`ended k0 success`).
[[nodiscard]] std::set<std::string> observe(const bridge::rl::Skillset& skillset);

/// The same observations, possible or not.
[[nodiscard]] std::set<std::string> allObservations(const bridge::rl::Skillset& skillset);

} // namespace proskill::test
