#pragma once

#include "viz/graph.h"
#include "viz/theme.h"

#include <string>
#include <string_view>
#include <vector>

/// Texts for Graphviz's HTML-like labels.
namespace proskill::viz {

/// Safe between tags: escapes `<`, `>`, `&` and quotes; replaces control characters and invalid
/// UTF-8.
[[nodiscard]] std::string escape(std::string_view text);
/// Safe in attributes that are plain text: valid UTF-8 without control characters.
[[nodiscard]] std::string clean(std::string_view text);
/// Breaks a text into lines of at most `width` characters; longer words are not broken.
[[nodiscard]] std::vector<std::string> wrap(std::string_view text, std::size_t width);

[[nodiscard]] std::string nodeLabel(const Node& node, Scheme scheme);
/// The title, and the legend of the colours in the picture.
[[nodiscard]] std::string titleAndLegend(const Graph& graph, Scheme scheme);

} // namespace proskill::viz
