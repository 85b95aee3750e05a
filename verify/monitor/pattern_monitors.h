#pragma once

#include "verify/model/monitor.h"
#include "verify/model/nodes.h"

#include "fiacre/syntax/tree.h"

#include <functional>
#include <optional>

namespace proskill::verify {

/// The monitor of a pattern that has to be checked along runs; nothing for combinations of a
/// pattern with scopes and times that have no meaning here. docs/fiacre.md defines the patterns;
/// compare Abid, Dal Zilio, Le Botlan, "Real-time specification patterns and tools", FMICS 2012.
/// \param atom returns the condition of an observable
[[nodiscard]] std::optional<Monitor>
monitorOf(const fiacre::Pattern& pattern, Nodes& nodes,
          const std::function<NodeId(const fiacre::Observable&)>& atom);

} // namespace proskill::verify
