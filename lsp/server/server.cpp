#include "lsp/server/server.h"

#include "analysis/program/stop.h"
#include "lsp/protocol/numbers.h"

#include "lsp/features/explain.h"
#include "lsp/protocol/convert.h"
#include "report/uri.h"

#include <thread>

namespace proskill::lsp {

namespace {

/// Longer results are sent in parts if the client supports it.
constexpr std::size_t kPart = 200;

const Json& idOf(const Json& params) { return rpc::memberAt(params, {"id"}); }

/// Sends a list in parts. LSP 3.17 then requires an empty answer.
Json inParts(Json list, const Progress& progress) {
  if (!progress.wantsParts() || !list.is_array() || list.size() <= kPart) return list;
  Json part = Json::array();
  for (auto& item : list) {
    part.push_back(std::move(item));
    if (part.size() == kPart) progress.part(std::exchange(part, Json::array()));
  }
  if (!part.empty()) progress.part(part);
  return Json::array();
}

} // namespace

Server::Server(rpc::Connection& connection, std::shared_ptr<const analysis::FileSystem> disk,
               ServerOptions serverOptions)
    : connection(connection),
      options(std::move(serverOptions)),
      outbox(connection),
      peer(outbox),
      log(options.log, peer),
      announcer(peer),
      workspace(std::move(disk)),
      verification({options.worker, [this](std::string_view body) { outbox.send(body); },
                    [this] { inbox.put([this] { verdictsChanged(); }); },
                    [this] { inbox.put([this] { durationsMeasured(); }); }, options.log}),
      publisher(
          peer, scheduler, statistics, client, [this] { return verification.verdicts(); },
          [this](const ide::Snapshot& snapshot) { findingsTold(snapshot); },
          [this](std::string_view method, const Json& params, std::string_view error) {
            log.writeFailure(method, params, error);
          }),
      scheduler(options.threads) {
  verification.addMethods(registry);
  registry.add("proskill/status",
               [this](const Request& request) -> Answer { return status(request.snapshot); });
  registry.capabilities["executeCommandProvider"] = {{"commands", Json::array({kExplainCommand})}};
  registry.add("workspace/executeCommand",
               [this](const Request& request) { return execute(request.params); });
}

/// The user asked for it, so errors are always shown.
Answer Server::execute(const Json& params) {
  const auto& command = rpc::memberAt(params, {"command"});
  if (command != kExplainCommand)
    return std::unexpected(
        rpc::RpcError{rpc::ErrorCode::InvalidParams, "there is no such command"});
  const auto& arguments = rpc::memberAt(params, {"arguments"});
  auto answer = explain(arguments.is_array() && !arguments.empty() ? arguments[0] : Json());
  if (!answer) return answer;
  peer.notify("window/showMessage",
              {{"type", protocol::MessageType::Info}, {"message", (*answer)["plain"]}});
  return Json();
}

int Server::run() {
  std::jthread reader([this] { readStream(); });
  while (true) {
    auto event = inbox.take(nextDeadline());
    if (!event) {
      if (parent.isGone()) break;
      onDeadline();
    } else if (!handle(*event)) {
      break;
    }
  }
  pending.cancelAll();
  connection.close();
  return phase == Phase::ShutDown ? 0 : 1;
}

std::optional<Server::Time> Server::nextDeadline() const {
  std::optional<Time> first;
  for (const auto& due : {publisher.due(), platforms.due(), refresher.due(), parent.due()})
    if (due && (!first || *due < *first)) first = due;
  return first;
}

void Server::onDeadline() {
  const auto now = std::chrono::steady_clock::now();
  if (publisher.due() && *publisher.due() <= now) {
    publisher.publish(workspace.snapshot(), settings->diagnostics);
    mistakes.publish(workspace.mistakes());
  }
  if (platforms.due() && *platforms.due() <= now)
    platforms.publish(workspace.snapshot(),
                      settings->diagnostics ? workspace.dataTexts() : DataTexts());
  if (refresher.due() && *refresher.due() <= now) refresher.refresh(*workspace.snapshot());
}

void Server::readStream() {
  rpc::FrameReader frames;
  for (auto bytes = connection.read(); !bytes.empty(); bytes = connection.read()) {
    frames.feed(bytes);
    while (auto next = frames.next()) receive(*next);
  }
  inbox.put(rpc::EndOfStream{});
}

void Server::receive(const rpc::Frame& frame) {
  if (const auto* error = std::get_if<rpc::FramingError>(&frame))
    return inbox.put(rpc::MalformedMessage{{rpc::ErrorCode::ParseError, error->message}, {}});
  auto message = rpc::parseMessage(std::get<std::string>(frame));
  if (!message) return inbox.put(message.error());
  receive(std::move(*message));
}

/// Cancels immediately: a cancellation must not queue after the request that it cancels.
void Server::receive(rpc::Message message) {
  if (message.kind == rpc::MessageKind::Notification && message.method == "$/cancelRequest") {
    const Json& id = idOf(message.params);
    if (pending.cancel(id))
      outbox.send(rpc::replyError(id, {rpc::ErrorCode::RequestCancelled, "cancelled"}));
    return;
  }
  if (message.kind != rpc::MessageKind::Request)
    return inbox.put(rpc::Received{std::move(message), {}, pending.count()});
  auto cancellation = pending.begin(message);
  if (!cancellation)
    return inbox.put(rpc::MalformedMessage{
        {rpc::ErrorCode::InvalidRequest, "`id` is already used by another request"},
        std::move(message.id)});
  inbox.put(rpc::Received{std::move(message), std::move(*cancellation)});
}

/// \return false if the server has to end
bool Server::handle(rpc::InboxEvent& event) {
  if (std::holds_alternative<rpc::EndOfStream>(event)) return false;
  if (auto* received = std::get_if<rpc::Received>(&event)) return handleMessage(*received);
  if (auto* task = std::get_if<rpc::Task>(&event)) {
    (*task)();
    return true;
  }
  const auto& malformed = std::get<rpc::MalformedMessage>(event);
  log.write("malformed message: " + malformed.error.message);
  outbox.send(rpc::replyError(malformed.id, malformed.error));
  // it may have been an edit, and a server cannot request texts from a client
  if (malformed.error.code == rpc::ErrorCode::ParseError && phase == Phase::Running)
    announcer.show(Announcer::Kind::Error,
                   "a message of the editor cannot be read; if ProSkill shows another text than "
                   "yours, please close the file and open it again");
  return true;
}

/// An exception becomes the error of this message only.
bool Server::handleMessage(rpc::Received& received) {
  auto& message = received.message;
  if (message.isRepaired) log.write(message.method + " contains half a character");
  try {
    switch (message.kind) {
    case rpc::MessageKind::Request: handleRequest(received); return true;
    case rpc::MessageKind::Notification: return handleNotification(received);
    case rpc::MessageKind::Response:
      if (!peer.answered(message)) log.write("a response without a request");
      return true;
    }
  } catch (const std::exception& error) {
    log.writeFailure(message.method, message.params, error.what());
    if (pending.finish(message.id))
      outbox.send(rpc::replyError(message.id, {rpc::ErrorCode::InternalError, error.what()}));
  }
  return true;
}

void Server::handleRequest(rpc::Received& received) {
  const auto& message = received.message;
  auto refuse = [&](rpc::ErrorCode code, std::string why) {
    if (pending.finish(message.id))
      outbox.send(rpc::replyError(message.id, {code, std::move(why)}));
  };
  auto give = [&](const Json& result) {
    if (pending.finish(message.id)) outbox.send(rpc::reply(message.id, result));
  };
  if (phase == Phase::ShutDown)
    return refuse(rpc::ErrorCode::InvalidRequest, "the server has been shut down");
  if (message.method == "initialize") {
    if (phase != Phase::Fresh)
      return refuse(rpc::ErrorCode::InvalidRequest, "the server is already initialised");
    return give(initialize(message.params));
  }
  if (phase == Phase::Fresh)
    return refuse(rpc::ErrorCode::ServerNotInitialized, "`initialize` comes first");
  if (message.method == "shutdown") {
    phase = Phase::ShutDown;
    refresher.stop();
    return give(nullptr);
  }
  auto method = registry.methods.find(message.method);
  if (method == registry.methods.end())
    return refuse(rpc::ErrorCode::MethodNotFound, "there is no method " + message.method);
  if (const auto* lost = lostTextFor(message)) return refuseLost(message, *lost);
  dispatch(received, method->second);
}

bool Server::handleNotification(rpc::Received& received) {
  if (received.message.method == "exit") return false;
  if (phase == Phase::Running) notified(received);
  return true;
}

namespace {

/// The lines of a `range`.
std::optional<Verification::Lines> linesIn(const Json& params) {
  const auto& first = rpc::memberAt(params, {"range", "start", "line"});
  const auto& last = rpc::memberAt(params, {"range", "end", "line"});
  if (!first.is_number_unsigned() || !last.is_number_unsigned()) return std::nullopt;
  return Verification::Lines{first.get<std::uint32_t>(), last.get<std::uint32_t>()};
}

} // namespace

void Server::notified(rpc::Received& received) {
  const auto& [method, params] = std::tie(received.message.method, received.message.params);
  if (method == "initialized") return initialized();
  if (method.starts_with("textDocument/did")) return handleText(received);
  if (method.starts_with("notebookDocument/did")) return handleNotebook(received);
  if (method == "workspace/didChangeWatchedFiles") return handleWatchedFiles(params);
  if (method == "workspace/didChangeWorkspaceFolders") return changeFolders(params);
  if (method == "workspace/didChangeConfiguration")
    return client.configuration ? askForSettings()
                                : setSettings(rpc::memberAt(params, {"settings"}));
  if (method == "proskill/view") {
    if (auto path = documentPath(params)) verification.setView(*path, linesIn(params));
    return;
  }
  if (method == "$/setTrace") return log.setTrace(rpc::memberAt(params, {"value"}));
  if (!method.starts_with("$/")) log.write("unsupported notification: " + method);
}

void Server::dispatch(rpc::Received& received, const Method& method) {
  auto& pool = method.priority == rpc::Priority::Long ? longWork : scheduler;
  pool.post(method.priority, [this, received = std::move(received), &method,
                              snapshot = workspace.snapshot(), settings = settings] {
    const auto& message = received.message;
    if (received.cancellation.isCancelled()) return;
    auto notify = [this](std::string_view what, const Json& params) { peer.notify(what, params); };
    Request request{message.params, *snapshot, client, received.cancellation};
    request.verdicts = verification.verdicts();
    request.settings = settings;
    request.progress =
        std::make_shared<Progress>(notify, rpc::memberAt(message.params, {"workDoneToken"}),
                                   rpc::memberAt(message.params, {"partialResultToken"}));
    answer(message, method, request);
    if (message.method.ends_with("/diagnostic")) findingsTold(*snapshot);
    if (auto replaced = snapshot->takeReplaced(); !replaced.empty()) forget(std::move(replaced));
  });
}

/// An exception in a handler becomes the error of this request only.
void Server::answer(const rpc::Message& message, const Method& method, const Request& request) {
  auto start = std::chrono::steady_clock::now();
  Answer result;
  auto bug = [&](std::string_view what) {
    ++errors;
    log.writeFailure(message.method, message.params, what);
    result = std::unexpected(rpc::RpcError{rpc::ErrorCode::InternalError, std::string(what)});
  };
  const analysis::StopWhen stop([&] { return request.cancellation.isCancelled(); });
  try {
    result = method.handler(request);
  } catch (const analysis::Stopped&) {
    result = std::unexpected(rpc::RpcError{rpc::ErrorCode::RequestCancelled, "cancelled"});
  } catch (const std::exception& error) {
    bug(error.what());
  } catch (...) {
    bug("an unknown error");
  }
  auto latency = std::chrono::steady_clock::now() - start;
  statistics.add(message.method, latency);
  const bool cancelled = request.cancellation.isCancelled();
  log.writeAnswer(message,
                  cancelled ? "cancelled"
                  : result  ? "ok"
                            : "error: " + result.error().message,
                  latency);
  reply(message, std::move(result), *request.progress);
}

void Server::reply(const rpc::Message& message, Answer result, Progress& progress) {
  if (!pending.finish(message.id)) return;
  progress.end();
  outbox.send(result ? rpc::reply(message.id, inParts(std::move(*result), progress))
                     : rpc::replyError(message.id, result.error()));
}

/// Texts are unchanged, so only what shows verdicts is refreshed.
void Server::verdictsChanged() {
  if (phase != Phase::Running) return;
  refresher.verdictsChanged();
  if (!client.pullDiagnostics) publisher.changed(std::chrono::milliseconds(0));
}

void Server::durationsMeasured() {
  verdictsChanged();
  if (phase == Phase::Running) refresher.hintsChanged();
}

/// Hints of a large program do not wait for its flow analysis. Findings do, so now it is available.
void Server::findingsTold(const ide::Snapshot& snapshot) {
  if (snapshot.takeMissedFlow()) refresher.hintsChanged();
}

/// Zero if the last analysis was fast, unless the user set a longer delay.
std::chrono::milliseconds Server::debounce() {
  const auto chosen = settings->debounce.value_or(options.debounce);
  return chosen <= kUsualDebounce && publisher.isQuick() ? std::chrono::milliseconds(0) : chosen;
}

} // namespace proskill::lsp
