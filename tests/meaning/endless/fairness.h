#pragma once

#include "tests/meaning/runs.h"

#include <functional>

namespace proskill::meaning {

/// Nodes and the ways between them, among which a run may go round for ever.
struct Circle {
  std::set<std::size_t> nodes;
  bool timeGoesOn = false; ///< from one of the nodes to the next
  bool hasStep = false;    ///< that takes no time
};

/// Which runs without end count.
enum class Counted : std::uint8_t { All, Fair };

[[nodiscard]] inline Counted countedBy(const syntax::Property& property) {
  return property.fair.value_or(true) ? Counted::Fair : Counted::All;
}

/// Of all runs, any way round counts that has a step. Of fair ones, whether a run may go round so
/// as runs of robots do: time goes on for ever, and nothing that may take any time takes for ever,
/// be it an action or a wait of a skill for a time. Such a run comes by each node and takes each
/// way. For time to go on, each age has to start anew again and again, or be beyond all bounds:
/// Alur and Dill (1994), lemma 4.13.
[[nodiscard]] bool counts(Counted counted, const Script& script, const Runs& runs,
                          const Circle& circle);

/// Whether the run may stay in the node for ever: of fair ones, time goes on there without end, and
/// with nothing that has to end; of all runs, no step comes any more.
[[nodiscard]] bool mayRest(Counted counted, const Script& script, const Runs& runs,
                           std::size_t node);

/// From which nodes a run that counts may go on for ever by these ways; those of a node are asked
/// for one by one. \param edge of a node, by place
using Allowed = std::function<bool(std::size_t node, std::size_t edge)>;
[[nodiscard]] std::vector<bool> goOn(Counted counted, const Script& script, const Runs& runs,
                                     const std::vector<bool>& nodes, const Allowed& edge);

} // namespace proskill::meaning
