#include "lsp/protocol/client.h"

#include <algorithm>
#include <array>

namespace proskill::lsp {

namespace {

bool isTrue(const Json& json, std::initializer_list<const char*> path) {
  return rpc::memberAt(json, path) == true;
}

constexpr std::array kEncodings{std::pair{"utf-8", syntax::Encoding::Utf8},
                                std::pair{"utf-16", syntax::Encoding::Utf16},
                                std::pair{"utf-32", syntax::Encoding::Utf32}};

bool lists(const Json& names, std::string_view name) {
  return names.is_array() && std::ranges::find(names, Json(name)) != names.end();
}

std::set<std::string> strings(const Json& json) {
  std::set<std::string> result;
  if (json.is_array())
    for (const auto& each : json)
      if (each.is_string()) result.insert(each.get<std::string>());
  return result;
}

/// Capabilities to refresh; that for diagnostics has two names.
std::set<std::string> refreshesOf(const Json& capabilities) {
  std::set<std::string> result;
  const auto& workspace = rpc::memberAt(capabilities, {"workspace"});
  for (const auto* what : {"codeLens", "diagnostic", "inlayHint", "inlineValue", "semanticTokens"})
    if (isTrue(workspace, {what, "refreshSupport"}))
      result.insert(std::string("workspace/") + what + "/refresh");
  if (isTrue(workspace, {"diagnostics", "refreshSupport"}))
    result.insert("workspace/diagnostic/refresh");
  return result;
}

/// Prefers UTF-8, the server's own encoding, which needs no conversion.
syntax::Encoding chooseEncoding(const Json& capabilities) {
  for (const auto* offered : {&rpc::memberAt(capabilities, {"general", "positionEncodings"}),
                              &rpc::memberAt(capabilities, {"offsetEncoding"})})
    for (const auto& [name, encoding] : kEncodings)
      if (lists(*offered, name)) return encoding;
  return syntax::Encoding::Utf16;
}

/// Whether the client requests diagnostics. Neovim requests them only for the edited text, so
/// others would be outdated: 0.10 cannot refresh them, and 0.12 then requests those of the
/// workspace but drops those of open texts. Therefore Neovim gets diagnostics pushed.
bool asksForDiagnostics(const Json& capabilities, const Json& name) {
  return rpc::memberAt(capabilities, {"textDocument", "diagnostic"}).is_object() &&
         name != "Neovim";
}

VerdictNews verdictNewsOf(const Json& wish) {
  if (wish == "changes") return VerdictNews::Changes;
  return wish == "all" ? VerdictNews::All : VerdictNews::None;
}

} // namespace

ClientFeatures readClientFeatures(const Json& capabilities, const Json& name) {
  ClientFeatures client;
  client.encoding = chooseEncoding(capabilities);
  client.pullDiagnostics = asksForDiagnostics(capabilities, name);
  client.relatedInformation =
      isTrue(capabilities, {"textDocument", "publishDiagnostics", "relatedInformation"}) ||
      isTrue(capabilities, {"textDocument", "diagnostic", "relatedInformation"});
  client.watchedFiles =
      isTrue(capabilities, {"workspace", "didChangeWatchedFiles", "dynamicRegistration"});
  client.dynamicTexts =
      isTrue(capabilities, {"textDocument", "synchronization", "dynamicRegistration"});
  client.workDoneProgress = isTrue(capabilities, {"window", "workDoneProgress"});
  const auto& item = rpc::memberAt(capabilities, {"textDocument", "completion", "completionItem"});
  client.snippets = isTrue(item, {"snippetSupport"});
  client.insertTextModes = rpc::memberAt(item, {"insertTextModeSupport"}).is_object();
  client.insertReplace = isTrue(item, {"insertReplaceSupport"});
  client.completionTags = rpc::memberAt(item, {"tagSupport"}).is_object();
  client.completionDeprecated = isTrue(item, {"deprecatedSupport"});
  client.markdownCompletion = lists(rpc::memberAt(item, {"documentationFormat"}), "markdown");
  const auto& signature =
      rpc::memberAt(capabilities, {"textDocument", "signatureHelp", "signatureInformation"});
  client.markdownSignature = lists(rpc::memberAt(signature, {"documentationFormat"}), "markdown");
  client.labelOffsets = isTrue(signature, {"parameterInformation", "labelOffsetSupport"});
  client.hierarchicalSymbols =
      isTrue(capabilities, {"textDocument", "documentSymbol", "hierarchicalDocumentSymbolSupport"});
  client.markdownHover =
      lists(rpc::memberAt(capabilities, {"textDocument", "hover", "contentFormat"}), "markdown");
  client.resolvesActions = lists(
      rpc::memberAt(capabilities, {"textDocument", "codeAction", "resolveSupport", "properties"}),
      "edit");
  client.documentChanges = isTrue(capabilities, {"workspace", "workspaceEdit", "documentChanges"});
  client.diagnosticTags =
      rpc::memberAt(capabilities, {"textDocument", "publishDiagnostics", "tagSupport"})
          .is_object() ||
      rpc::memberAt(capabilities, {"textDocument", "diagnostic", "tagSupport"}).is_object();
  client.codeDescription =
      isTrue(capabilities, {"textDocument", "publishDiagnostics", "codeDescriptionSupport"}) ||
      isTrue(capabilities, {"textDocument", "diagnostic", "codeDescriptionSupport"});
  client.configuration = isTrue(capabilities, {"workspace", "configuration"});
  client.dynamicConfiguration =
      isTrue(capabilities, {"workspace", "didChangeConfiguration", "dynamicRegistration"});
  client.verdictNews = verdictNewsOf(rpc::memberAt(capabilities, {"experimental", "verdicts"}));
  client.retried = strings(
      rpc::memberAt(capabilities, {"general", "staleRequestSupport", "retryOnContentModified"}));
  client.resolvedOfHints = strings(
      rpc::memberAt(capabilities, {"textDocument", "inlayHint", "resolveSupport", "properties"}));
  client.refreshes = refreshesOf(capabilities);
  if (!client.pullDiagnostics) client.refreshes.erase("workspace/diagnostic/refresh");
  return client;
}

std::string_view nameOf(syntax::Encoding encoding) {
  return std::ranges::find(kEncodings, encoding, [](const auto& pair) { return pair.second; })
      ->first;
}

} // namespace proskill::lsp
