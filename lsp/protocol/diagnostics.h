#pragma once

#include "ide/description/diagnostics.h"
#include "ide/verdicts/verdicts.h"
#include "lsp/protocol/convert.h"

namespace proskill::lsp {

/// \param elsewhere an entry of `relatedInformation` about a file that is not of the program; null:
/// none
[[nodiscard]] Json diagnosticJson(const ide::Finding& finding, const Converter& convert,
                                  const ClientFeatures& client, const Json& elsewhere);

/// The diagnostics of an open text in the protocol's format, from all its programs, each once;
/// those of bad verdicts come last.
[[nodiscard]] Json diagnosticsOf(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                                 const ClientFeatures& client, const ide::Verdicts& verdicts);

} // namespace proskill::lsp
