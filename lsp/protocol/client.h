#pragma once

#include "lsp/protocol/manual.h"
#include "rpc/rpc.h"
#include "syntax/text/position.h"

#include <memory>
#include <set>
#include <string>

namespace proskill::lsp {

/// Which verdicts a client receives by `proskill/verdicts`: its capability `experimental.verdicts`.
enum class VerdictNews : std::uint8_t {
  None,    ///< no notifications: it may not know this extension of the protocol
  All,     ///< all verdicts of the program: "all"
  Changes, ///< those that have changed since the last notification: "changes"
};

/// The capabilities of the client that the server uses.
struct ClientFeatures {
  syntax::Encoding encoding = syntax::Encoding::Utf16;
  bool pullDiagnostics = false; ///< pulls diagnostics; otherwise they are pushed
  bool relatedInformation = false;
  bool watchedFiles = false; ///< may be registered dynamically
  bool dynamicTexts = false; ///< sends open texts of kinds that are registered dynamically
  bool workDoneProgress = false;
  bool snippets = false;
  bool insertTextModes = false; ///< of snippets that say how their lines are indented
  bool insertReplace = false;   ///< completions may have separate ranges for insert and replace
  bool completionTags = false;
  bool completionDeprecated = false; ///< the older way to mark completions as deprecated
  bool markdownCompletion = false;   ///< in the documentation of completions
  bool markdownSignature = false;
  bool labelOffsets = false; ///< of a signature's parameters
  bool hierarchicalSymbols = false;
  bool markdownHover = false;
  /// Requests the edit of a code action only when the user chooses it.
  bool resolvesActions = false;
  bool documentChanges = false; ///< workspace edits with versions
  bool diagnosticTags = false;
  bool codeDescription = false; ///< shows links from the codes of diagnostics
  /// The target of these links; null if the client shows none.
  std::shared_ptr<const Manual> manual;
  bool configuration = false;        ///< can be asked for its settings
  bool dynamicConfiguration = false; ///< notifies about changes of its settings
  VerdictNews verdictNews = VerdictNews::None;
  /// Methods that it repeats if a request was rejected because the text has changed.
  std::set<std::string> retried;
  /// Members of inlay hints that it resolves later: `label.location`.
  std::set<std::string> resolvedOfHints;
  /// Refresh requests that it supports: `workspace/codeLens/refresh`.
  std::set<std::string> refreshes;
};

/// Reads the `capabilities` of `initialize`, including the older `offsetEncoding` of clangd's
/// extension.
/// \param name of the client, from `clientInfo`
[[nodiscard]] ClientFeatures readClientFeatures(const Json& capabilities,
                                                const Json& name = nullptr);

/// The encoding's name in the protocol.
[[nodiscard]] std::string_view nameOf(syntax::Encoding encoding);

} // namespace proskill::lsp
