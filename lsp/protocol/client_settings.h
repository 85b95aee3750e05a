#pragma once

#include "rpc/rpc.h"

#include <chrono>
#include <optional>

namespace proskill::lsp {

/// What users set in their editor, in its section `proskill`; see docs/lsp.md. What is absent or of
/// the wrong type is as if it had not been said.
struct ClientSettings {
  bool diagnostics = true; ///< told at all
  bool style = false;      ///< hints of style too, whatever `.proskill.json` says
  std::optional<std::chrono::milliseconds> debounce; ///< absent: as the command line says
};

/// From the value of the section, or of the member `proskill` of an object of sections.
[[nodiscard]] ClientSettings readClientSettings(const Json& json);

} // namespace proskill::lsp
