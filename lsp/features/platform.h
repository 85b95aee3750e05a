#pragma once

#include "ide/answers/hover.h"
#include "ide/snapshot/snapshot.h"
#include "lsp/protocol/client.h"

#include <optional>

/// The platform that a program names by `defplatform`. Its file is only read: nothing that it names
/// is loaded or started.
namespace proskill::lsp {

/// What is wrong with the platforms that the programs with this file name in it.
[[nodiscard]] Json platformDiagnostics(const ide::Snapshot& snapshot,
                                       const std::filesystem::path& file,
                                       const ClientFeatures& client);

/// What is wrong with an open platform file, in it, for the open programs that name it.
[[nodiscard]] Json platformFileDiagnostics(const ide::Snapshot& snapshot,
                                           const std::filesystem::path& file, std::string_view text,
                                           const ClientFeatures& client);

/// Who performs the actions, if the place is in the path of a platform file that can be read.
[[nodiscard]] std::optional<ide::Hover> platformHover(const ide::Snapshot& snapshot,
                                                      const ide::View& view, syntax::Offset at);

} // namespace proskill::lsp
