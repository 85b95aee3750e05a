#pragma once

#include "analysis/program/program.h"
#include "bridge/text/emitted.h"

#include <expected>

namespace proskill::bridge::bt {

struct EmittedTree {
  Emitted tree;       ///< the XML
  std::string leaves; ///< what `import bt --leaves` reads: durations and results of its leaves
};

/// A composite skill, with the skills that it calls, as a tree of BehaviorTree.CPP v4 that means
/// the same if the assumptions about ticks hold (docs/import.md), and if its leaves do what the
/// basic skills declare.
/// \param skill empty: the mission
/// \return the tree, or the parts that a tree cannot say
[[nodiscard]] std::expected<EmittedTree, Errors> emitTree(const analysis::Program& program,
                                                          std::string_view skill);

} // namespace proskill::bridge::bt
