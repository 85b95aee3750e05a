#pragma once

#include "ide/diagnostics.h"
#include "lsp/convert.h"

namespace proskill::lsp {

[[nodiscard]] Json diagnosticJson(const ide::Finding& finding, const Converter& convert,
                                  const ClientFeatures& client);

/// The diagnostics of an open text in the protocol's form, from all programs that it belongs to,
/// each once.
[[nodiscard]] Json diagnosticsOf(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                                 const ClientFeatures& client);

} // namespace proskill::lsp
