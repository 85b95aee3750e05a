#pragma once

#include "verify/explore/search.h"
#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/system.h"

#include <vector>

namespace proskill::verify {

/// A system without locations in which an instance does nothing that matters.
struct Contracted {
  System system;
  Steps before;                ///< steps that have been taken where the system starts
  std::vector<Steps> original; ///< by transition: the steps that it joins
};

/// Joins steps of one instance. A location is removed if nothing decides when the instance leaves
/// it and nobody notices: its steps have no condition and no clock, are never due, and write
/// nothing that matters; and where they lead no step is ever due. A step that leads to such a
/// location leads on at once. What is reachable stays reachable, and nothing becomes so.
/// \param system without a state layout, and without priorities
/// \param goals ask for reachable states or steps
/// \throw LimitMet
[[nodiscard]] Contracted contracted(const System& system, const std::vector<Goal>& goals,
                                    LimitWatch& limits);

} // namespace proskill::verify
