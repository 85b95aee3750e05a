#pragma once

#include "viz/graph.h"

#include <string_view>

namespace proskill::viz {

enum class Scheme : std::uint8_t { Light, Dark };

/// The style of nodes with a role. Colours are in the format of Graphviz and SVG: `#rrggbb`.
struct NodeStyle {
  std::string_view id;      ///< `call`: for SVG classes
  std::string_view meaning; ///< in the legend; empty: not in the legend
  std::string_view shape;
  std::string_view style;
  std::string_view fill;
  std::string_view line;
};

struct EdgeStyle {
  std::string_view id;
  std::string_view meaning;
  std::string_view style;
  std::string_view colour;
  std::string_view sign; ///< its symbol in the legend
};

struct PageStyle {
  std::string_view background;
  std::string_view text;
  std::string_view faint; ///< details, labels of edges, the legend
  std::string_view frame; ///< lines of clusters
  std::string_view shade; ///< background of clusters
};

/// Verdana has the same width, for machines without DejaVu.
inline constexpr std::string_view kFont = "DejaVu Sans,Verdana,sans-serif";

[[nodiscard]] NodeStyle nodeStyle(NodeRole role, Scheme scheme);
[[nodiscard]] EdgeStyle edgeStyle(EdgeRole role, Scheme scheme);
[[nodiscard]] PageStyle pageStyle(Scheme scheme);

} // namespace proskill::viz
