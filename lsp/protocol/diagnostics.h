#pragma once

#include "analysis/program/originals.h"
#include "ide/description/diagnostics.h"
#include "ide/verdicts/verdicts.h"
#include "lsp/protocol/convert.h"

namespace proskill::lsp {

/// \param original of the finding's place, in an imported program
[[nodiscard]] Json diagnosticJson(const ide::Finding& finding, const Converter& convert,
                                  const ClientFeatures& client,
                                  const std::optional<analysis::Original>& original);

/// The diagnostics of an open text in the protocol's format, from all its programs, each once;
/// those of bad verdicts come last.
[[nodiscard]] Json diagnosticsOf(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                                 const ClientFeatures& client, const ide::Verdicts& verdicts);

} // namespace proskill::lsp
