#pragma once

#include <graphviz/gvc.h>

namespace proskill::viz {

/// A plugin by which Graphviz measures text without fonts, for `gvContextPlugins`. What it measures
/// can be written as SVG alone: those who draw text as pixels want to have measured it themselves.
[[nodiscard]] const lt_symlist_t* textLayoutPlugin();

} // namespace proskill::viz
