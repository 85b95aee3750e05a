#pragma once

#include <string_view>

/// The panel's files from `panel/dist/`, which the build embeds into this program.
namespace proskill::view::bundle {

extern const std::string_view panelJs;
extern const std::string_view panelCss;
/// The content security policy's hashes for pages that contain these files: `{"script": "sha256-…",
/// "style": "sha256-…"}`.
extern const std::string_view hashesJson;

} // namespace proskill::view::bundle
