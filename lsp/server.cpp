#include "lsp/server.h"

#include "lsp/convert.h"
#include "lsp/diagnostics.h"
#include "lsp/uri.h"

#include <fmt/format.h>

#include <thread>

namespace proskill::lsp {

namespace {

constexpr std::string_view kPattern = "**/*.proskill";

Json idOf(const Json& params) {
  return params.is_object() && params.contains("id") ? params["id"] : Json();
}

/// The folders of `initialize`, whichever of its three ways of saying them the client uses.
std::vector<std::filesystem::path> foldersOf(const Json& params) {
  std::vector<std::filesystem::path> result;
  auto add = [&](const Json& uri) {
    if (!uri.is_string()) return;
    if (auto path = toPath(uri.get_ref<const std::string&>())) result.push_back(*path);
  };
  if (auto folders = params.find("workspaceFolders");
      folders != params.end() && folders->is_array())
    for (const auto& folder : *folders)
      if (folder.is_object()) add(folder.value("uri", Json()));
  if (result.empty()) add(params.value("rootUri", Json()));
  return result;
}

} // namespace

Server::Server(Connection& connection, std::shared_ptr<const analysis::FileSystem> disk,
               ServerOptions serverOptions)
    : connection(connection),
      options(std::move(serverOptions)),
      outbox(connection),
      workspace(std::move(disk)),
      verification({options.worker, [this](std::string_view body) { outbox.send(body); },
                    [this] { inbox.put(VerdictsChanged{}); }, options.log}),
      scheduler(options.threads) {
  verification.addMethods(registry);
  registry.add("proskill/status", [this](const Request&) -> Answer { return status(); });
}

int Server::run() {
  std::jthread reader([this] { readStream(); });
  while (true) {
    auto incident = inbox.take(diagnosticsDue);
    if (!incident)
      pushDiagnostics();
    else if (!handle(*incident))
      break;
  }
  pending.cancelAll();
  connection.close();
  return phase == Phase::ShutDown ? 0 : 1;
}

void Server::readStream() {
  FrameReader frames;
  for (auto bytes = connection.read(); !bytes.empty(); bytes = connection.read()) {
    frames.feed(bytes);
    while (auto next = frames.next()) receive(*next);
  }
  inbox.put(EndOfStream{});
}

void Server::receive(const Frame& frame) {
  if (const auto* error = std::get_if<FramingError>(&frame))
    return inbox.put(MalformedMessage{{ErrorCode::ParseError, error->message}, {}});
  auto message = parseMessage(std::get<std::string>(frame));
  if (!message) return inbox.put(message.error());
  receive(std::move(*message));
}

/// Cancels on the spot: a cancellation must not wait behind what it cancels.
void Server::receive(Message message) {
  if (message.kind == MessageKind::Notification && message.method == "$/cancelRequest") {
    auto id = idOf(message.params);
    if (pending.cancel(id)) outbox.send(replyError(id, {ErrorCode::RequestCancelled, "cancelled"}));
    return;
  }
  if (message.kind != MessageKind::Request) return inbox.put(Received{std::move(message), {}});
  auto cancellation = pending.begin(message.id);
  if (!cancellation)
    return inbox.put(
        MalformedMessage{{ErrorCode::InvalidRequest, "`id` is that of a request that waits"},
                         std::move(message.id)});
  inbox.put(Received{std::move(message), std::move(*cancellation)});
}

/// False where the server's life ends here.
bool Server::handle(Incident& incident) {
  if (std::holds_alternative<EndOfStream>(incident)) return false;
  if (auto* received = std::get_if<Received>(&incident)) return handleMessage(*received);
  if (std::holds_alternative<VerdictsChanged>(incident)) {
    verdictsChanged();
    return true;
  }
  const auto& malformed = std::get<MalformedMessage>(incident);
  log("malformed message: " + malformed.error.message);
  outbox.send(replyError(malformed.id, malformed.error));
  return true;
}

/// What a message does to this thread is that message's error, and nobody's end.
bool Server::handleMessage(Received& received) {
  auto& message = received.message;
  try {
    switch (message.kind) {
    case MessageKind::Request: handleRequest(received); return true;
    case MessageKind::Notification: return handleNotification(message);
    case MessageKind::Response: return true; // to our registrations; nothing depends on them
    }
  } catch (const std::exception& error) {
    failed(message.method, message.params, error);
    if (pending.finish(message.id))
      outbox.send(replyError(message.id, {ErrorCode::InternalError, error.what()}));
  }
  return true;
}

void Server::handleRequest(Received& received) {
  const auto& message = received.message;
  auto refuse = [&](ErrorCode code, std::string why) {
    if (pending.finish(message.id)) outbox.send(replyError(message.id, {code, std::move(why)}));
  };
  auto give = [&](const Json& result) {
    if (pending.finish(message.id)) outbox.send(reply(message.id, result));
  };
  if (phase == Phase::ShutDown)
    return refuse(ErrorCode::InvalidRequest, "the server has been shut down");
  if (message.method == "initialize") {
    if (phase != Phase::Fresh)
      return refuse(ErrorCode::InvalidRequest, "the server is initialised already");
    return give(initialize(message.params));
  }
  if (phase == Phase::Fresh)
    return refuse(ErrorCode::ServerNotInitialized, "`initialize` comes first");
  if (message.method == "shutdown") {
    phase = Phase::ShutDown;
    return give(nullptr);
  }
  auto method = registry.methods.find(message.method);
  if (method == registry.methods.end())
    return refuse(ErrorCode::MethodNotFound, "there is no method " + message.method);
  dispatch(received, method->second);
}

bool Server::handleNotification(const Message& message) {
  if (message.method == "exit") return false;
  if (phase != Phase::Running) return true;
  if (message.method == "initialized")
    initialized();
  else if (message.method.starts_with("textDocument/did"))
    handleText(message);
  else if (message.method == "workspace/didChangeWatchedFiles")
    handleWatchedFiles(message.params);
  else if (message.method == "proskill/view") {
    if (auto path = documentPath(message.params)) verification.setView(*path);
  } else if (!message.method.starts_with("$/"))
    log("a notification that is not served: " + message.method);
  return true;
}

void Server::handleText(const Message& message) {
  Workspace::Outcome outcome;
  if (message.method == "textDocument/didOpen")
    outcome = workspace.open(message.params);
  else if (message.method == "textDocument/didChange")
    outcome = workspace.change(message.params);
  else if (message.method == "textDocument/didClose")
    outcome = workspace.close(message.params);
  else
    return;
  if (!outcome) showError(outcome.error());
  verification.textsChanged(workspace.snapshot(), outcome ? std::optional(*outcome) : std::nullopt);
  scheduleDiagnostics();
}

void Server::handleWatchedFiles(const Json& params) {
  if (!params.is_object() || !params.contains("changes") || !params["changes"].is_array()) return;
  std::vector<std::filesystem::path> paths;
  for (const auto& change : params["changes"])
    if (change.is_object() && change.contains("uri") && change["uri"].is_string())
      if (auto path = toPath(change["uri"].get_ref<const std::string&>())) paths.push_back(*path);
  workspace.readFiles(paths);
  verification.textsChanged(workspace.snapshot(), std::nullopt);
  scheduleDiagnostics();
}

/// The texts are as they were: what is being published of them is not out of date.
void Server::verdictsChanged() {
  if (phase != Phase::Running) return;
  const auto ask = [&](bool wanted, const char* method) {
    if (wanted) outbox.send(request(fmt::format("{} {}", method, ++lastRefresh), method, nullptr));
  };
  ask(client.pullDiagnostics && client.refreshDiagnostics, "workspace/diagnostic/refresh");
  ask(client.refreshCodeLens, "workspace/codeLens/refresh");
  ask(client.refreshInlayHints, "workspace/inlayHint/refresh");
  if (!client.pullDiagnostics && !diagnosticsDue) diagnosticsDue = std::chrono::steady_clock::now();
}

Json Server::initialize(const Json& params) {
  phase = Phase::Running;
  client = readClientFeatures(params.is_object() ? params.value("capabilities", Json()) : Json());
  workspace.setEncoding(client.encoding);
  verification.start(
      client,
      initialSettings(params.is_object() ? params.value("initializationOptions", Json()) : Json()));
  if (params.is_object()) folders = foldersOf(params);
  Json capabilities = registry.capabilities;
  capabilities["positionEncoding"] = nameOf(client.encoding);
  capabilities["textDocumentSync"] = {{"openClose", true}, {"change", 2}, {"save", true}};
  capabilities["workspace"] = {{"workspaceFolders", {{"supported", true}}}};
  return {{"capabilities", capabilities},
          {"serverInfo", {{"name", "proskill"}, {"version", options.version}}},
          {"offsetEncoding", nameOf(client.encoding)}};
}

void Server::initialized() {
  for (const auto& folder : folders) workspace.readFiles(programFiles(folder));
  if (client.watchedFiles)
    outbox.send(
        request("watch", "client/registerCapability",
                {{"registrations",
                  Json::array({{{"id", "watch"},
                                {"method", "workspace/didChangeWatchedFiles"},
                                {"registerOptions",
                                 {{"watchers", Json::array({{{"globPattern", kPattern}}})}}}}})}}));
  scheduleDiagnostics();
}

void Server::dispatch(Received& received, const Method& method) {
  auto& pool = method.priority == Priority::Long ? longWork : scheduler;
  pool.post(method.priority,
            [this, received = std::move(received), &method, snapshot = workspace.snapshot()] {
              answer(received.message, method, *snapshot, received.cancellation);
            });
}

/// A bug in a handler is that request's error, and no other's.
void Server::answer(const Message& message, const Method& method, const ide::Snapshot& snapshot,
                    const Cancellation& cancellation) {
  if (cancellation.isCancelled()) return;
  auto start = std::chrono::steady_clock::now();
  Answer result;
  try {
    result =
        method.handler({message.params, snapshot, client, cancellation, verification.verdicts()});
  } catch (const std::exception& error) {
    failed(message.method, message.params, error);
    result = std::unexpected(RpcError{ErrorCode::InternalError, error.what()});
  }
  auto latency = std::chrono::steady_clock::now() - start;
  statistics.add(message.method, latency);
  log(fmt::format("{} {:.3f} ms", message.method,
                  std::chrono::duration<double, std::milli>(latency).count()));
  if (!pending.finish(message.id)) return;
  outbox.send(result ? reply(message.id, *result) : replyError(message.id, result.error()));
}

void Server::scheduleDiagnostics() {
  ++revision;
  if (!client.pullDiagnostics) diagnosticsDue = std::chrono::steady_clock::now() + options.debounce;
}

/// Publishes for every open text, and an empty list for those that have been closed. What a later
/// edit has made useless is not sent.
void Server::pushDiagnostics() {
  diagnosticsDue.reset();
  auto snapshot = workspace.snapshot();
  std::map<std::filesystem::path, std::string> now;
  for (const auto& [path, text] : snapshot->open()) now[path] = text.uri;
  {
    const std::lock_guard lock(publishing);
    for (const auto& [path, uri] : std::exchange(published, now))
      if (!now.contains(path))
        outbox.send(notification("textDocument/publishDiagnostics",
                                 {{"uri", uri}, {"diagnostics", Json::array()}}));
  }
  for (const auto& [path, uri] : now)
    scheduler.post(Priority::Background, [this, snapshot, path = path, asked = revision.load()] {
      publish(*snapshot, path, asked);
    });
}

void Server::publish(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                     std::uint64_t asked) {
  if (asked != revision) return;
  const auto& text = snapshot.open().at(path);
  try {
    auto list = diagnosticsOf(snapshot, path, client, *verification.verdicts());
    const std::lock_guard lock(publishing);
    if (asked != revision) return;
    outbox.send(notification(
        "textDocument/publishDiagnostics",
        {{"uri", text.uri}, {"version", text.version}, {"diagnostics", std::move(list)}}));
  } catch (const std::exception& error) {
    failed("textDocument/publishDiagnostics", {{"uri", text.uri}}, error);
  }
}

Json Server::status() const {
  return {{"version", options.version},
          {"pending", pending.size()},
          {"memoryBytes", residentBytes()},
          {"requests", statistics.latencies()}};
}

void Server::log(std::string_view line) const {
  if (options.log) options.log(line);
}

void Server::failed(std::string_view method, const Json& params,
                    const std::exception& error) const {
  log(fmt::format("{} failed: {}; its parameters: {}", method, error.what(),
                  params.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

void Server::showError(std::string_view message) {
  log(message);
  outbox.send(notification("window/logMessage", {{"type", 1}, {"message", message}}));
}

} // namespace proskill::lsp
