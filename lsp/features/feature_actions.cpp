#include "analysis/program/originals.h"
#include "ide/actions/action.h"
#include "lsp/features/explain.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/diagnostics.h"
#include "lsp/protocol/edits.h"
#include "lsp/verification/verdict_json.h"

#include <algorithm>

namespace proskill::lsp {

namespace {

/// In the order of `ide::ActionKind`.
constexpr std::array<std::string_view, 6> kKinds{"quickfix",        "refactor.extract",
                                                 "refactor.inline", "refactor.rewrite",
                                                 "source.fixAll",   "source.organizeFields"};

std::string_view nameOf(ide::ActionKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

/// Whether a kind was requested, or is below a requested kind, as `refactor.inline` is below
/// `refactor`.
bool isAskedFor(std::string_view kind, const Json& params) {
  auto context = params.find("context");
  if (context == params.end() || !context->is_object()) return true;
  auto only = context->find("only");
  if (only == context->end() || !only->is_array()) return true;
  return std::ranges::any_of(*only, [&](const Json& wish) {
    if (!wish.is_string()) return false;
    auto name = wish.get<std::string>();
    return kind == name || name.empty() || kind.starts_with(name + ".");
  });
}

/// The edits of each file, with the document version if the client supports it.
Json workspaceEdit(const ide::Action& action, const Request& request) {
  const Converter convert(action.owner->program, request.snapshot.open(), request.client.encoding);
  std::map<analysis::FileId, std::vector<syntax::TextEdit>> files;
  for (const auto& [file, edit] : action.edits) files[file].push_back(edit);
  Json changes = Json::object();
  Json documents = Json::array();
  for (const auto& [file, edits] : files) {
    auto open = request.snapshot.open().find(action.owner->program.files[file].path);
    Json version = open == request.snapshot.open().end() ? Json() : Json(open->second.version);
    auto json = textEdits(convert, file, edits);
    changes[convert.uri(file)] = json;
    documents.push_back({{"textDocument", {{"uri", convert.uri(file)}, {"version", version}}},
                         {"edits", std::move(json)}});
  }
  return request.client.documentChanges ? Json{{"documentChanges", std::move(documents)}}
                                        : Json{{"changes", std::move(changes)}};
}

std::int64_t versionOf(const Request& request, const std::filesystem::path& path) {
  auto open = request.snapshot.open().find(path);
  return open == request.snapshot.open().end() ? 0 : open->second.version;
}

Json actionJson(const ide::Action& action, const Request& request) {
  Json json{{"title", action.title}, {"kind", nameOf(action.kind)}};
  if (action.preferred) json["isPreferred"] = true;
  if (action.fixes) {
    const Converter convert(action.owner->program, request.snapshot.open(),
                            request.client.encoding);
    const auto original =
        analysis::ProgramOriginals(action.owner->program).of(action.fixes->location);
    const auto diagnostic = diagnosticJson({action.owner, action.fixes}, convert, request.client,
                                           original ? relatedOriginal(*original) : Json());
    json["diagnostics"] =
        Json::array({Json::parse(rpc::dump(diagnostic))}); // `resolve` compares it
  }
  if (!action.explains.empty())
    json["command"] = {{"title", action.title},
                       {"command", kExplainCommand},
                       {"arguments", Json::array({action.explains})}};
  return json;
}

Answer codeAction(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  auto selection = rangeIn(*view, request.params, request.client.encoding);
  if (!selection) return std::unexpected(selection.error());
  auto path = *documentFile(request);
  Json result = Json::array();
  for (const auto& action : ide::actions(request.snapshot, path, *selection)) {
    if (!isAskedFor(nameOf(action.kind), request.params)) continue;
    auto json = actionJson(action, request);
    const bool edits = action.explains.empty();
    if (edits && request.client.resolvesActions)
      json["data"] = {{"textDocument", request.params["textDocument"]},
                      {"version", versionOf(request, path)},
                      {"range", request.params["range"]}};
    else if (edits)
      json["edit"] = workspaceEdit(action, request);
    result.push_back(std::move(json));
  }
  return result;
}

/// Computes the actions again, and returns the chosen one if its text is unchanged.
Answer resolveAction(const Request& request) {
  if (request.params.contains("command")) return request.params; // some clients resolve all actions
  auto data = request.params.find("data");
  if (data == request.params.end() || !data->is_object() || !request.params.contains("title"))
    return std::unexpected(
        rpc::RpcError{rpc::ErrorCode::InvalidParams, "`data` or `title` is missing"});
  const Request again{*data,
                      request.snapshot,
                      request.client,
                      request.cancellation,
                      request.verdicts,
                      request.settings,
                      request.progress};
  auto view = documentView(again);
  if (!view) return std::unexpected(view.error());
  auto selection = rangeIn(*view, *data, request.client.encoding);
  if (!selection) return std::unexpected(selection.error());
  auto path = *documentPath(*data);
  Json stale = data->contains("version") ? (*data)["version"] : Json();
  if (stale != versionOf(request, path))
    return std::unexpected(
        rpc::RpcError{rpc::ErrorCode::ContentModified, "the text has changed since"});
  for (const auto& action : ide::actions(request.snapshot, path, *selection)) {
    auto json = actionJson(action, request);
    bool same = json["title"] == request.params["title"] &&
                json.value("diagnostics", Json()) == request.params.value("diagnostics", Json());
    if (!same) continue;
    Json resolved = request.params;
    resolved["edit"] = workspaceEdit(action, request);
    return resolved;
  }
  return std::unexpected(requestFailed("this action is no longer possible here"));
}

} // namespace

void addActions(Registry& registry) {
  registry.add("textDocument/codeAction", codeAction);
  registry.add("codeAction/resolve", resolveAction);
  registry.capabilities["codeActionProvider"] = {{"codeActionKinds", kKinds},
                                                 {"resolveProvider", true}};
}

} // namespace proskill::lsp
