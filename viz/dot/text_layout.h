#pragma once

#include <graphviz/gvc.h>

namespace proskill::viz {

/// A plugin for `gvContextPlugins` that lets Graphviz measure text without fonts. It supports only
/// SVG output: renderers of pixels insist on measuring text themselves.
[[nodiscard]] const lt_symlist_t* textLayoutPlugin();

} // namespace proskill::viz
