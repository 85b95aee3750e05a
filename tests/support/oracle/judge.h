#pragma once

#include "tests/support/oracle/region_graph.h"

namespace proskill::oracle {

/// What is seen at a moment: a discrete state and, where something happens in it, the step.
struct Moment {
  const Store* before = nullptr;
  const Firing* firing = nullptr; ///< null: nothing happens
};

[[nodiscard]] bool observed(const Interpreter& model, const fiacre::Observable& observable,
                            Moment moment);

/// Whether the pattern is true of the model, by looking at every node. Absent, Always, DeadlockFree
/// and Progress, without scopes and times; nothing for the others. \pre the graph is complete
[[nodiscard]] std::optional<bool> isTrue(const Interpreter& model, const RegionGraph& graph,
                                         const fiacre::Pattern& pattern);

} // namespace proskill::oracle
