#pragma once

#include <graphviz/cgraph.h>

namespace proskill::viz {

/// Numbers the parts of a graph as they come. cgraph by itself takes the addresses of their names,
/// and walks subgraphs in that order: no two runs would give the same picture.
[[nodiscard]] Agiddisc_t* sequentialIds();

} // namespace proskill::viz
