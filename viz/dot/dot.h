#pragma once

#include "viz/graph.h"
#include "viz/theme.h"

#include <graphviz/cgraph.h>

#include <memory>
#include <string>
#include <string_view>

namespace proskill::viz {

struct CloseGraph {
  void operator()(Agraph_t* graph) const { agclose(graph); }
};
using CGraph = std::unique_ptr<Agraph_t, CloseGraph>;

/// The graph as a cgraph object with shapes and colours. Each node has the attributes `id`,
/// `class`, `range` (`file:begin-end`, in bytes), `URL` (`file#begin-end`) and `tooltip`
/// (`file:line:column`, from 1). \pre no other thread uses Graphviz, because it has global state
[[nodiscard]] CGraph toCGraph(const Graph& graph, Scheme scheme);

[[nodiscard]] std::string writeDot(Agraph_t* graph);
/// Null if the text is not DOT.
[[nodiscard]] CGraph readDot(std::string_view dot);

} // namespace proskill::viz
