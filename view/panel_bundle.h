#pragma once

#include <string_view>

/// The panel's program, as `panel/dist/` has it; the build puts its bytes into this one.
namespace proskill::view::bundle {

extern const std::string_view panelJs;
extern const std::string_view panelCss;
/// What a page that holds them within itself says of them in its policy:
/// `{"script": "sha256-…", "style": "sha256-…"}`.
extern const std::string_view hashesJson;

} // namespace proskill::view::bundle
