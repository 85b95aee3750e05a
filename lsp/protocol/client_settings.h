#pragma once

#include "rpc/rpc.h"

#include <chrono>
#include <optional>

namespace proskill::lsp {

/// The settings of the editor's section `proskill`; see docs/lsp.md. Values that are absent or of
/// the wrong type are ignored.
struct ClientSettings {
  bool diagnostics = true; ///< whether they are reported at all
  bool style = false;      ///< also style hints, whatever `.proskill.json` says
  std::optional<std::chrono::milliseconds> debounce; ///< absent: the value of the command line
};

/// Reads the value of the section, or of the member `proskill` of an object of sections.
[[nodiscard]] ClientSettings readClientSettings(const Json& json);

} // namespace proskill::lsp
