#include "lsp/server/capabilities.h"
#include "lsp/server/server.h"
#include "report/uri.h"

/// From `initialize` on: negotiation with the client, its folders and settings.
namespace proskill::lsp {

namespace {

std::optional<std::filesystem::path> pathIn(const Json& json) {
  const Json& uri = rpc::memberAt(json, {"uri"});
  return uri.is_string() ? report::toPath(uri.get_ref<const std::string&>()) : std::nullopt;
}

std::vector<std::filesystem::path> pathsIn(const Json& list) {
  std::vector<std::filesystem::path> result;
  if (list.is_array())
    for (const auto& each : list)
      if (auto path = pathIn(each)) result.push_back(*path);
  return result;
}

/// The folders of `initialize`, which clients send in one of three ways.
std::vector<std::filesystem::path> foldersOf(const Json& params) {
  auto result = pathsIn(rpc::memberAt(params, {"workspaceFolders"}));
  if (!result.empty()) return result;
  const Json& uri = rpc::memberAt(params, {"rootUri"});
  const Json& path = rpc::memberAt(params, {"rootPath"});
  if (uri.is_string()) {
    if (auto root = report::toPath(uri.get_ref<const std::string&>())) result.push_back(*root);
  } else if (path.is_string()) {
    result.emplace_back(path.get<std::string>());
  }
  return result;
}

} // namespace

Json Server::initialize(const Json& params) {
  phase = Phase::Running;
  client = readClientFeatures(rpc::memberAt(params, {"capabilities"}),
                              rpc::memberAt(params, {"clientInfo", "name"}));
  if (client.codeDescription) client.manual = std::make_shared<const Manual>(options.manual);
  workspace.setEncoding(client.encoding);
  folders.set(foldersOf(params));
  parent = ParentWatch(rpc::memberAt(params, {"processId"}));
  log.setTrace(rpc::memberAt(params, {"trace"}));
  const Json& first = rpc::memberAt(params, {"initializationOptions"});
  verification.start(client, initialSettings(first));
  if (first.is_object()) setSettings(first);
  return {{"capabilities", capabilitiesFor(client, registry.capabilities)},
          {"serverInfo", {{"name", "proskill"}, {"version", options.version}}},
          {"offsetEncoding", nameOf(client.encoding)}};
}

void Server::initialized() {
  if (Json wanted = registrationsFor(client); !wanted.empty())
    peer.ask("client/registerCapability", {{"registrations", std::move(wanted)}});
  askForSettings();
  folders.readAll();
  changed();
}

void Server::askForSettings() {
  if (!client.configuration) return;
  peer.ask("workspace/configuration", {{"items", Json::array({{{"section", "proskill"}}})}},
           [this](const Json& result) {
             if (result.is_array() && !result.empty()) setSettings(result[0]);
           });
}

void Server::setSettings(const Json& json) {
  settings = std::make_shared<const ClientSettings>(readClientSettings(json));
  const Json& whole = rpc::memberAt(json, {"proskill"});
  verification.configure(rpc::memberAt(whole.is_object() ? whole : json, {"verify"}));
  workspace.setStyle(settings->style);
  changed();
  refresher.findingsChanged(debounce());
}

void Server::changeFolders(const Json& params) {
  folders.change(pathsIn(rpc::memberAt(params, {"event", "removed"})),
                 pathsIn(rpc::memberAt(params, {"event", "added"})));
  changed();
  refresher.allChanged(debounce());
}

void Server::foldersRead() {
  textsChanged();
  refresher.allChanged(debounce());
}

void Server::handleWatchedFiles(const Json& params) {
  const auto before = workspace.snapshot();
  auto paths = folders.filesOf(pathsIn(rpc::memberAt(params, {"changes"})));
  std::erase_if(paths, [this](const auto& path) { return !workspace.dependsOn(path); });
  if (paths.empty()) return;
  folders.filesChanged(paths);
  filesChanged(paths, *before);
}

/// What programs read has changed: files on the disk, or the open texts of platform files.
void Server::filesChanged(const std::vector<Path>& paths, const ide::Snapshot& before) {
  textsChanged();
  std::vector<Path> files;
  for (const auto& path : paths) files.push_back(before.nameOf(path));
  verification.filesChanged(files);
  for (const auto& file : files) {
    if (before.open().contains(file)) continue;
    refresher.findingsChanged(debounce());
    refresher.changed(file, before, debounce());
  }
}

} // namespace proskill::lsp
