#pragma once

#include "viz/graph.h"
#include "viz/theme.h"

#include <expected>
#include <string>

namespace proskill::viz {

enum class Format : std::uint8_t { Dot, Svg, Png };

/// The picture's bytes; the same graph gives the same bytes. What Graphviz complains about is the
/// error, and never goes to standard error. May be called from any thread: Graphviz runs in one at
/// a time.
[[nodiscard]] std::expected<std::string, std::string> render(const Graph& graph, Format format,
                                                             Scheme scheme);

} // namespace proskill::viz
