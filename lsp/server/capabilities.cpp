#include "lsp/server/capabilities.h"
#include "lsp/protocol/numbers.h"

namespace proskill::lsp {

namespace {

Json registration(const char* method, Json registerOptions) {
  return {{"id", method}, {"method", method}, {"registerOptions", std::move(registerOptions)}};
}

Json watchers() {
  Json result = Json::array();
  for (const char* pattern : {"**/*.proskill", "**/*.fcr", "**/*.json"})
    result.push_back({{"globPattern", pattern}});
  return result;
}

/// Open platform files. Only their texts are registered, so that other features remain those of the
/// editor's server for JSON.
void addPlatformTexts(Json& registrations) {
  Json files = Json::array();
  for (const char* language : {"json", "jsonc"})
    files.push_back({{"language", language}, {"pattern", "**/{platform,*.platform}.json"}});
  const Json options{{"documentSelector", files}};
  registrations.push_back(registration("textDocument/didOpen", options));
  registrations.push_back(
      registration("textDocument/didChange", {{"documentSelector", files},
                                              {"syncKind", protocol::TextDocumentSyncKind::Full}}));
  registrations.push_back(registration("textDocument/didClose", options));
}

/// ProSkill cells in notebooks of any kind.
Json notebookSync() {
  const Json cells = Json::array({{{"language", "proskill"}}});
  return {{"notebookSelector", Json::array({{{"notebook", "*"}, {"cells", cells}}})},
          {"save", true}};
}

} // namespace

Json capabilitiesFor(const ClientFeatures& client, Json features) {
  // either pushed or pulled, not both
  if (!client.pullDiagnostics) features.erase("diagnosticProvider");
  features["positionEncoding"] = nameOf(client.encoding);
  features["textDocumentSync"] = {{"openClose", true},
                                  {"change", protocol::TextDocumentSyncKind::Incremental},
                                  {"save", {{"includeText", false}}}};
  features["notebookDocumentSync"] = notebookSync();
  features["workspace"]["workspaceFolders"] = {{"supported", true}, {"changeNotifications", true}};
  return features;
}

Json registrationsFor(const ClientFeatures& client) {
  Json registrations = Json::array();
  if (client.watchedFiles)
    registrations.push_back(
        registration("workspace/didChangeWatchedFiles", {{"watchers", watchers()}}));
  if (client.dynamicConfiguration)
    registrations.push_back(
        registration("workspace/didChangeConfiguration", {{"section", "proskill"}}));
  if (client.dynamicTexts) addPlatformTexts(registrations);
  return registrations;
}

} // namespace proskill::lsp
