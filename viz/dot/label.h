#pragma once

#include "viz/graph.h"
#include "viz/theme.h"

#include <string>
#include <string_view>
#include <vector>

/// Texts as Graphviz's HTML-like labels.
namespace proskill::viz {

/// Safe between tags: `<`, `>`, `&` and quotes escaped, control characters and what is no UTF-8
/// replaced.
[[nodiscard]] std::string escape(std::string_view text);
/// Safe in attributes that are plain text: valid UTF-8 without control characters.
[[nodiscard]] std::string clean(std::string_view text);
/// Lines of at most `width` characters where the words allow it.
[[nodiscard]] std::vector<std::string> wrap(std::string_view text, std::size_t width);

[[nodiscard]] std::string nodeLabel(const Node& node, Scheme scheme);
/// The title, and what the colours mean that are in the picture.
[[nodiscard]] std::string titleAndLegend(const Graph& graph, Scheme scheme);

} // namespace proskill::viz
