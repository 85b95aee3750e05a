#pragma once

#include "viz/graph.h"
#include "viz/theme.h"

#include <expected>
#include <string>

namespace proskill::viz {

enum class Format : std::uint8_t { Dot, Svg, Png };

/// The picture as bytes; equal graphs give equal bytes. The error contains Graphviz's messages,
/// which never go to standard error. Thread-safe, but only one call runs Graphviz at a time.
[[nodiscard]] std::expected<std::string, std::string> render(const Graph& graph, Format format,
                                                             Scheme scheme);

} // namespace proskill::viz
