#pragma once

#include "tests/support/oracle/judge.h"

namespace proskill::oracle {

/// Whether a pattern with scopes and times is true, by examining runs point by point. In a region
/// graph every kind of date is a node, so nothing can happen in between. nullopt for unknown
/// patterns. \pre the graph has a watch beyond the pattern's times, and is complete
[[nodiscard]] std::optional<bool> isTrueOfPoints(const Interpreter& model, const RegionGraph& graph,
                                                 const fiacre::Pattern& pattern);

/// Whether an LTL formula is true of all runs. Positions carry all formulas that may be true there,
/// as in Lichtenstein and Pnueli, "Checking that finite state concurrent programs satisfy their
/// linear specification", POPL 1985. \pre the graph is complete
[[nodiscard]] bool isTrueOfRuns(const Interpreter& model, const RegionGraph& graph,
                                const fiacre::Ltl& formula);

} // namespace proskill::oracle
