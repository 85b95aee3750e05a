#pragma once

#include <graphviz/cgraph.h>

namespace proskill::viz {

/// Numbers the parts of a graph in order of creation. By default cgraph uses the addresses of their
/// names and iterates over subgraphs in this order, so no two runs would draw the same picture.
[[nodiscard]] Agiddisc_t* sequentialIds();

} // namespace proskill::viz
