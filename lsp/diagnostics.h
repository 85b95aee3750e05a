#pragma once

#include "ide/verdicts.h"
#include "lsp/client.h"

namespace proskill::lsp {

/// The diagnostics of an open text in the protocol's form, from all programs that it belongs to,
/// each once; those of bad verdicts last.
[[nodiscard]] Json diagnosticsOf(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                                 const ClientFeatures& client, const ide::Verdicts& verdicts);

} // namespace proskill::lsp
