#include "lsp/server/server.h"

#include "lsp/protocol/convert.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::lsp {

namespace {

/// Limit of edits that are combined, so that later messages need not wait long.
constexpr unsigned kMostGathered = 1000;

std::string uriOf(const Json& params) {
  const Json& uri = rpc::memberAt(params, {"textDocument", "uri"});
  return uri.is_string() ? uri.get<std::string>() : std::string();
}

bool isEdit(const rpc::Message& message) {
  return message.kind == rpc::MessageKind::Notification &&
         message.method == "textDocument/didChange" &&
         rpc::memberAt(message.params, {"contentChanges"}).is_array() &&
         rpc::memberAt(message.params, {"textDocument", "version"}).is_number_integer();
}

/// Whether one edit directly follows the other, and both can be applied together.
bool continues(const rpc::Message& next, const rpc::Message& edit) {
  return isEdit(next) && !next.isRepaired && !edit.isRepaired &&
         uriOf(next.params) == uriOf(edit.params) &&
         next.params["textDocument"]["version"] > edit.params["textDocument"]["version"];
}

} // namespace

/// Combines an edit with those of the same text that follow it in the queue: no request refers to
/// the states between, and parsing once is faster.
void Server::gatherEdits(rpc::Message& edit) {
  for (unsigned i = 0; i < kMostGathered; ++i) {
    auto next = inbox.takeIf([&](const rpc::InboxEvent& event) {
      const auto* received = std::get_if<rpc::Received>(&event);
      return received && continues(received->message, edit);
    });
    if (!next) return;
    auto& params = std::get<rpc::Received>(*next).message.params;
    edit.params["textDocument"] = std::move(params["textDocument"]);
    for (auto& change : params["contentChanges"])
      edit.params["contentChanges"].push_back(std::move(change));
  }
}

void Server::handleText(rpc::Received& received) {
  rpc::Message& message = received.message;
  if (isEdit(message) && !workspace.isIncluded(message.params)) gatherEdits(message);
  const auto path = documentPath(message.params);
  if (path && Workspace::isData(*path)) return handleData(message);
  Workspace::Outcome outcome;
  auto before = workspace.snapshot();
  if (message.method == "textDocument/didOpen")
    outcome = workspace.open(message.params, ide::TextKind::File, message.isRepaired);
  else if (message.method == "textDocument/didChange")
    outcome = workspace.change(message.params, message.isRepaired);
  else if (message.method == "textDocument/didClose")
    outcome = workspace.close(message.params);
  else if (message.method == "textDocument/didSave")
    outcome = workspace.saved(message.params);
  else
    return log.write("unsupported notification: " + message.method);
  if (!outcome) {
    const auto* lost = path ? lostIn(workspace.inexactTexts(), *path) : nullptr;
    announcer.show(Announcer::Kind::Error,
                   outcome.error() + (lost ? resynchronizer.remedy(*lost) : ""));
  }
  if (message.method == "textDocument/didChange")
    refuseStale(uriOf(message.params), received.order);
  std::vector<Path> texts;
  if (path && message.method != "textDocument/didSave") texts.push_back(*path);
  textsChanged(texts, std::move(before));
  synchronized(message);
}

/// A text may have been lost, or be known again. \pre its diagnostics are not being published
void Server::synchronized(const rpc::Message& message) {
  const auto& inexact = workspace.inexactTexts();
  for (const auto& [path, text] : inexact) {
    if (text.isLost)
      publisher.leave(path);
    else if (message.isRepaired)
      announcer.show(Announcer::Kind::Warning,
                     "`" + path.filename().generic_string() +
                         "` contains half a character, which is read as U+FFFD");
  }
  resynchronizer.update(inexact);
}

/// The lost text that a request is about, or that it could edit; null if there is none.
const InexactText* Server::lostTextFor(const rpc::Message& request) const {
  const auto& inexact = workspace.inexactTexts();
  const auto lost =
      std::ranges::find_if(inexact, [](const auto& entry) { return entry.second.isLost; });
  if (lost == inexact.end()) return nullptr;
  if (request.method == "textDocument/rename" || request.method == "workspace/willRenameFiles")
    return &lost->second;
  const auto path = documentPath(request.params);
  return path ? lostIn(inexact, *path) : nullptr;
}

/// Clients ignore an answer with `ContentModified` without a message; the user has had one.
void Server::refuseLost(const rpc::Message& request, const InexactText& lost) {
  if (!pending.finish(request.id)) return;
  if (request.method == "textDocument/diagnostic") {
    const Json report{{"kind", "full"}, {"items", resynchronizer.diagnostics(lost)}};
    return outbox.send(rpc::reply(request.id, report));
  }
  outbox.send(rpc::replyError(request.id,
                              {rpc::ErrorCode::ContentModified, resynchronizer.explanation(lost)}));
}

/// An open platform file is read in place of the one on the disk.
void Server::handleData(const rpc::Message& message) {
  const auto before = workspace.snapshot();
  Workspace::Outcome outcome;
  if (message.method == "textDocument/didOpen")
    outcome = workspace.openData(message.params);
  else if (message.method == "textDocument/didChange")
    outcome = workspace.changeData(message.params);
  else if (message.method == "textDocument/didClose")
    outcome = workspace.closeData(message.params);
  else
    return; // what was saved is what was edited
  if (!outcome) return announcer.show(Announcer::Kind::Error, outcome.error());
  platforms.changed(debounce());
  filesChanged({*outcome}, *before);
}

void Server::handleNotebook(const rpc::Received& received) {
  const auto& [method, params] = std::tie(received.message.method, received.message.params);
  auto before = workspace.snapshot();
  Notebooks::Outcome outcome;
  if (method == "notebookDocument/didOpen")
    outcome = notebooks.open(params, received.message.isRepaired);
  else if (method == "notebookDocument/didChange")
    outcome = notebooks.change(params, received.message.isRepaired);
  else if (method == "notebookDocument/didClose")
    outcome = notebooks.close(params);
  else if (method != "notebookDocument/didSave")
    log.write("unsupported notification: " + method);
  for (const auto& problem : outcome.problems) {
    log.write(fmt::format("{}: {}", method, problem));
    announcer.show(Announcer::Kind::Error, problem);
  }
  for (const auto& path : outcome.changed)
    if (auto text = before->open().find(path); text != before->open().end())
      refuseStale(text->second.uri, received.order);
  if (!outcome.changed.empty()) textsChanged(outcome.changed, std::move(before));
  synchronized(received.message);
}

/// The client changed texts; the last one is in view.
void Server::textsChanged(const std::vector<Path>& texts,
                          std::shared_ptr<const ide::Snapshot> before) {
  changed();
  for (const auto& path : texts) refresher.changed(path, *before, debounce());
  verification.textsChanged(workspace.snapshot(), lostPaths(workspace.inexactTexts()),
                            texts.empty() ? std::nullopt : std::optional(texts.back()));
  forget(std::move(before));
}

/// Rejects requests about the text before the edit; the client sends them again.
void Server::refuseStale(const std::string& uri, std::uint64_t order) {
  for (const auto& [id, method] : pending.about(uri, client.retried, order))
    if (pending.cancel(id))
      outbox.send(rpc::replyError(id, {rpc::ErrorCode::ContentModified, "the text has changed"}));
  static const std::set<std::string> kPulled{"textDocument/diagnostic"};
  for (const auto& [id, method] : pending.about(uri, kPulled, order))
    if (pending.cancel(id))
      outbox.send(rpc::replyError(id, {rpc::ErrorCode::ServerCancelled, "the text has changed",
                                       Json{{"retriggerRequest", true}}}));
}

void Server::changed() {
  if (!client.pullDiagnostics) publisher.changed(debounce());
  if (!workspace.dataTexts().empty()) platforms.changed(debounce());
}

/// Texts changed other than by editing.
void Server::textsChanged() {
  changed();
  verification.textsChanged(workspace.snapshot(), lostPaths(workspace.inexactTexts()),
                            std::nullopt);
}

} // namespace proskill::lsp
