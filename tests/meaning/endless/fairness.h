#pragma once

#include "tests/meaning/runs.h"

#include <functional>

namespace proskill::meaning {

/// Nodes and edges between them, on which a run may cycle for ever.
struct Circle {
  std::set<std::size_t> nodes;
  bool timeGoesOn = false; ///< from one of the nodes to the next
  bool hasStep = false;    ///< without delay
};

/// Which infinite runs count.
struct Counted {
  bool all = false;
  std::set<std::string_view> ending; ///< skills whose actions and waits end; empty: all skills
};

[[nodiscard]] Counted countedBy(const syntax::Property& property);

/// Whether a counted run can cycle here. Of all runs, any cycle with a step counts. A fair run goes
/// on like the run of a robot: time passes for ever, and actions and waits without a time limit end
/// eventually. Such a run visits each node and takes each edge. For time to pass, each age must be
/// reset infinitely often, or be beyond all bounds: Alur and Dill (1994), lemma 4.13.
[[nodiscard]] bool counts(const Counted& counted, const Script& script, const Runs& runs,
                          const Circle& circle);

/// Whether a counted run may stay in the node for ever. Of fair runs: time passes without end, and
/// nothing is due to end; of all runs: no further step is possible, or none has to happen.
[[nodiscard]] bool mayRest(const Counted& counted, const Script& script, const Runs& runs,
                           std::size_t node);

/// The nodes from which a counted run may go on for ever along these edges, which are tested one by
/// one. \param edge index of an edge of a node
using Allowed = std::function<bool(std::size_t node, std::size_t edge)>;
[[nodiscard]] std::vector<bool> goOn(const Counted& counted, const Script& script, const Runs& runs,
                                     const std::vector<bool>& nodes, const Allowed& edge);

} // namespace proskill::meaning
