#pragma once

#include "tests/support/oracle/judge.h"

namespace proskill::oracle {

/// Whether a pattern with scopes and times is true, by looking at runs point by point: in a graph
/// of regions every kind of date is a node of its own, so that nothing needs to be thought about
/// what happens in between. Nothing for patterns that are not known here. \pre the graph has a
/// watch beyond the pattern's times, and is complete
[[nodiscard]] std::optional<bool> isTrueOfPoints(const Interpreter& model, const RegionGraph& graph,
                                                 const fiacre::Pattern& pattern);

/// Whether a formula of LTL is true of all runs: positions with all that may be true of them, as in
/// Lichtenstein and Pnueli, "Checking that finite state concurrent programs satisfy their linear
/// specification", POPL 1985. \pre the graph is complete
[[nodiscard]] bool isTrueOfRuns(const Interpreter& model, const RegionGraph& graph,
                                const fiacre::Ltl& formula);

} // namespace proskill::oracle
