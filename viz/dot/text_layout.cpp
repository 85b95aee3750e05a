#include "viz/dot/text_layout.h"

#include "viz/dot/text_width.h"

#include <cmath>

extern "C" {
#include <graphviz/gvplugin_textlayout.h>
}

namespace proskill::viz {
namespace {

/// The height of a line, and the part of it below the middle, on which text is centred.
constexpr double kHeight = 1.164;
constexpr double kBelowMiddle = 0.1;

boolean measure(textspan_t* span, char** /*fontPath*/) {
  const auto size = span->font->size;
  const bool bold = (span->font->flags & HTML_BF) != 0;
  span->size = {textWidth(span->str, bold) * size, std::round(kHeight * size)};
  span->yoffset_layout = size;
  span->yoffset_centerline = kBelowMiddle * size;
  span->layout = nullptr;
  span->free_layout = nullptr;
  return true;
}

} // namespace

const lt_symlist_t* textLayoutPlugin() {
  constexpr int kBeforeAllOthers = 100;
  static char type[] = "textlayout";
  static char package[] = "proskill";
  static gvtextlayout_engine_t engine{measure};
  static gvplugin_installed_t types[]{{0, type, kBeforeAllOthers, &engine, nullptr}, {}};
  static gvplugin_api_t apis[]{{API_textlayout, types}, {}};
  static gvplugin_library_t library{package, apis};
  static const lt_symlist_t plugins[]{{"gvplugin_proskill_LTX_library", &library}, {}};
  return plugins;
}

} // namespace proskill::viz
