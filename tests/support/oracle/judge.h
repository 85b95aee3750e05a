#pragma once

#include "tests/support/oracle/region_graph.h"

namespace proskill::oracle {

/// A point: a discrete state and, if there is one, the step that leaves it.
struct Moment {
  const Store* before = nullptr;
  const Firing* firing = nullptr; ///< null: no step
};

[[nodiscard]] bool observed(const Interpreter& model, const fiacre::Observable& observable,
                            Moment moment);

/// Whether the pattern is true of the model, by examining every node. Supports Absent, Always,
/// DeadlockFree, Progress and AlwaysReachable without scopes and times; nullopt for others. \pre
/// the graph is complete
[[nodiscard]] std::optional<bool> isTrue(const Interpreter& model, const RegionGraph& graph,
                                         const fiacre::Pattern& pattern);

} // namespace proskill::oracle
