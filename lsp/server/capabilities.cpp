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
  return registrations;
}

} // namespace proskill::lsp
