#include "lsp/server/server.h"

#include "lsp/workspace/program_settings.h"
#include "report/uri.h"
#include "syntax/text/position.h"

#include <fmt/format.h>

#include <algorithm>

#include <csignal>

/// From `initialize` on: what is settled with the client, and what it says of its folders and
/// settings.
namespace proskill::lsp {

namespace {

constexpr std::chrono::seconds kBetweenLooks{5};

Json rangeOf(const SettingsMistake& mistake, Encoding encoding) {
  const syntax::LineIndex lines(mistake.text);
  auto position = [&](syntax::Offset at) {
    const auto [line, character] = toEditor(mistake.text, lines, at, encoding);
    return Json{{"line", line}, {"character", character}};
  };
  return {{"start", position(mistake.at.begin)}, {"end", position(mistake.at.end)}};
}

std::optional<std::filesystem::path> pathIn(const Json& json) {
  const Json& uri = memberAt(json, {"uri"});
  return uri.is_string() ? toPath(uri.get_ref<const std::string&>()) : std::nullopt;
}

std::vector<std::filesystem::path> pathsIn(const Json& list) {
  std::vector<std::filesystem::path> result;
  if (list.is_array())
    for (const auto& each : list)
      if (auto path = pathIn(each)) result.push_back(*path);
  return result;
}

/// The folders of `initialize`, whichever of its three ways of saying them the client uses.
std::vector<std::filesystem::path> foldersOf(const Json& params) {
  auto result = pathsIn(memberAt(params, {"workspaceFolders"}));
  if (!result.empty()) return result;
  const Json& uri = memberAt(params, {"rootUri"});
  const Json& path = memberAt(params, {"rootPath"});
  if (uri.is_string()) {
    if (auto root = toPath(uri.get_ref<const std::string&>())) result.push_back(*root);
  } else if (path.is_string()) {
    result.emplace_back(path.get<std::string>());
  }
  return result;
}

bool isRunning(int process) { return kill(process, 0) == 0 || errno != ESRCH; }

/// A client elsewhere, in a container or behind a port, has a number that means nothing here.
std::optional<int> parentOf(const Json& params) {
  const Json& id = memberAt(params, {"processId"});
  if (!id.is_number_unsigned() || id.get<std::uint64_t>() > INT32_MAX) return std::nullopt;
  const int process = id.get<int>();
  return process > 0 && isRunning(process) ? std::optional(process) : std::nullopt;
}

Json registration(const char* method, Json registerOptions) {
  return {{"id", method}, {"method", method}, {"registerOptions", std::move(registerOptions)}};
}

Json watchers() {
  Json result = Json::array();
  for (const char* pattern : {"**/*.proskill", "**/*.fcr", "**/.proskill.json"})
    result.push_back({{"globPattern", pattern}});
  return result;
}

/// Cells in ProSkill, whatever the notebook.
Json notebookSync() {
  const Json cells = Json::array({{{"language", "proskill"}}});
  return {{"notebookSelector", Json::array({{{"notebook", "*"}, {"cells", cells}}})},
          {"save", true}};
}

} // namespace

Json Server::initialize(const Json& params) {
  phase = Phase::Running;
  client = readClientFeatures(memberAt(params, {"capabilities"}),
                              memberAt(params, {"clientInfo", "name"}));
  if (client.codeDescription) client.manual = std::make_shared<const Manual>(options.manual);
  workspace.setEncoding(client.encoding);
  folders = foldersOf(params);
  parent = parentOf(params);
  if (parent) parentDue = std::chrono::steady_clock::now() + kBetweenLooks;
  setTrace(memberAt(params, {"trace"}));
  const Json& first = memberAt(params, {"initializationOptions"});
  verification.start(client, initialSettings(first));
  if (first.is_object()) setSettings(first);
  Json capabilities = registry.capabilities;
  if (!client.pullDiagnostics)
    capabilities.erase("diagnosticProvider"); // what is told, nobody asks for
  capabilities["positionEncoding"] = nameOf(client.encoding);
  capabilities["textDocumentSync"] = {
      {"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}};
  capabilities["notebookDocumentSync"] = notebookSync();
  capabilities["workspace"]["workspaceFolders"] = {{"supported", true},
                                                   {"changeNotifications", true}};
  return {{"capabilities", capabilities},
          {"serverInfo", {{"name", "proskill"}, {"version", options.version}}},
          {"offsetEncoding", nameOf(client.encoding)}};
}

void Server::initialized() {
  registerCapabilities();
  askForSettings();
  readFolders(folders);
  changed();
}

void Server::registerCapabilities() {
  Json registrations = Json::array();
  if (client.watchedFiles)
    registrations.push_back(
        registration("workspace/didChangeWatchedFiles", {{"watchers", watchers()}}));
  if (client.dynamicConfiguration)
    registrations.push_back(
        registration("workspace/didChangeConfiguration", {{"section", "proskill"}}));
  if (!registrations.empty())
    peer.ask("client/registerCapability", {{"registrations", std::move(registrations)}});
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
  const Json& whole = memberAt(json, {"proskill"});
  verification.configure(memberAt(whole.is_object() ? whole : json, {"verify"}));
  workspace.setStyle(settings->style);
  changed();
  refresher.findingsChanged(debounce());
}

void Server::changeFolders(const Json& params) {
  auto removed = pathsIn(memberAt(params, {"event", "removed"}));
  auto added = pathsIn(memberAt(params, {"event", "added"}));
  std::erase_if(folders, [&](const Path& it) { return std::ranges::count(removed, it) > 0; });
  workspace.forget(removed, folders);
  if (readings > 0) removedMeanwhile.insert(removedMeanwhile.end(), removed.begin(), removed.end());
  folders.insert(folders.end(), added.begin(), added.end());
  readFolders(std::move(added));
  changed();
  refresher.allChanged(debounce());
}

/// On another thread, for a folder may be large: edits and requests do not wait for it. Progress is
/// shown from when the client has agreed to it; most folders are read before that.
void Server::readFolders(std::vector<Path> some) {
  if (some.empty()) return;
  auto agreed = std::make_shared<std::atomic<bool>>(false);
  const std::string token = "proskill/folders/" + some.front().generic_string();
  if (client.workDoneProgress)
    peer.ask("window/workDoneProgress/create", {{"token", token}},
             [agreed](const Json&) { *agreed = true; });
  ++readings;
  scheduler.post(Priority::Background, [this, some = std::move(some), agreed, token] {
    Progress progress([this](auto what, const Json& params) { peer.notify(what, params); }, token,
                      nullptr);
    auto found = std::make_shared<FolderContents>(
        workspace.read(some, [&](std::size_t done, std::size_t all) {
          if (!*agreed) return;
          progress.begin("Reading programs", false);
          progress.report(fmt::format("{} of {} files", done, all),
                          static_cast<unsigned>(100 * done / all));
        }));
    inbox.put([this, found] {
      workspace.add(std::move(*found));
      catchUp();
      textsChanged();
      refresher.allChanged(debounce());
    });
  });
}

/// What was told while folders were read is newer than what was read.
void Server::catchUp() {
  if (!changedMeanwhile.empty()) workspace.readFiles(changedMeanwhile);
  if (!removedMeanwhile.empty()) workspace.forget(removedMeanwhile, folders);
  if (--readings > 0) return;
  changedMeanwhile.clear();
  removedMeanwhile.clear();
}

void Server::handleWatchedFiles(const Json& params) {
  const auto before = workspace.snapshot();
  const auto paths = pathsIn(memberAt(params, {"changes"}));
  if (readings > 0) changedMeanwhile.insert(changedMeanwhile.end(), paths.begin(), paths.end());
  workspace.readFiles(paths);
  textsChanged();
  for (const auto& path : paths) {
    const auto file = before->nameOf(path);
    if (before->open().contains(file)) continue;
    refresher.findingsChanged(debounce());
    refresher.changed(file, *before, debounce());
  }
}

/// A mistaken file of settings is told like a mistake in a program.
void Server::showMistakes() {
  auto now = workspace.mistakes();
  if (now == mistakes) return;
  for (const auto& [file, mistake] : mistakes)
    if (!now.contains(file))
      peer.notify("textDocument/publishDiagnostics",
                  {{"uri", toUri(file)}, {"diagnostics", Json::array()}});
  for (const auto& [file, mistake] : now)
    peer.notify("textDocument/publishDiagnostics",
                {{"uri", toUri(file)},
                 {"diagnostics", Json::array({{{"range", rangeOf(mistake, client.encoding)},
                                               {"severity", 1},
                                               {"source", "proskill"},
                                               {"message", mistake.words}}})}});
  mistakes = std::move(now);
}

void Server::setTrace(const Json& value) {
  if (value == "off") trace = Trace::Off;
  if (value == "messages") trace = Trace::Messages;
  if (value == "verbose") trace = Trace::Verbose;
}

bool Server::parentIsGone() {
  auto now = std::chrono::steady_clock::now();
  if (!parentDue || now < *parentDue) return false;
  parentDue = now + kBetweenLooks;
  return !isRunning(*parent);
}

} // namespace proskill::lsp
