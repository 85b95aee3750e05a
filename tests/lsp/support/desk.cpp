#include "tests/lsp/support/desk.h"

#include "rpc/json_writer.h"
#include "tests/lsp/support/byte_places.h"
#include "tests/support/memory_files.h"

#include <stdexcept>

namespace proskill::test {

namespace {

std::string uriOf(const std::string& file) { return "file:///w/" + file; }

/// Requested once per text, not for each place in it.
const std::set<std::string_view> kOfDocuments{
    "textDocument/codeLens",
    "textDocument/diagnostic",
    "textDocument/documentColor",
    "textDocument/documentLink",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/formatting",
    "textDocument/inlayHint",
    "textDocument/inlineValue",
    "textDocument/rangeFormatting",
    "textDocument/rangesFormatting",
    "textDocument/semanticTokens/full",
    "textDocument/semanticTokens/full/delta",
    "textDocument/semanticTokens/range",
};

/// Methods that take the items of an answer: as they are, or as the member `item`.
struct FollowUp {
  std::string_view method;
  std::string_view next;
  bool asItem;
};
constexpr FollowUp kFollowUps[] = {
    {"textDocument/completion", "completionItem/resolve", false},
    {"textDocument/codeAction", "codeAction/resolve", false},
    {"textDocument/codeLens", "codeLens/resolve", false},
    {"textDocument/inlayHint", "inlayHint/resolve", false},
    {"textDocument/documentLink", "documentLink/resolve", false},
    {"workspace/symbol", "workspaceSymbol/resolve", false},
    {"textDocument/prepareCallHierarchy", "callHierarchy/incomingCalls", true},
    {"textDocument/prepareCallHierarchy", "callHierarchy/outgoingCalls", true},
    {"textDocument/prepareTypeHierarchy", "typeHierarchy/supertypes", true},
    {"textDocument/prepareTypeHierarchy", "typeHierarchy/subtypes", true},
};

lsp::ClientFeatures featuresOf(syntax::Encoding encoding) {
  lsp::ClientFeatures result;
  result.encoding = encoding;
  result.pullDiagnostics = result.relatedInformation = result.snippets = true;
  result.insertReplace = result.hierarchicalSymbols = result.documentChanges = true;
  result.markdownHover = result.markdownCompletion = true;
  result.resolvedOfHints = {"tooltip", "label.location"};
  return result;
}

/// Methods with this prefix, except those requested once per document.
std::vector<std::string> select(const lsp::Registry& registry, std::string_view begin,
                                bool ofDocuments) {
  std::vector<std::string> result;
  for (const auto& [name, method] : registry.methods)
    if (name.starts_with(begin) && kOfDocuments.contains(name) == ofDocuments)
      result.push_back(name);
  return result;
}

const Json& itemsOf(const Json& answer) {
  const auto& items = rpc::memberAt(answer, {"items"});
  return items.is_array() ? items : answer;
}

} // namespace

Desk::Desk(const std::map<std::string, std::string>& files, syntax::Encoding encoding)
    : client(featuresOf(encoding)) {
  ide::OpenTexts texts;
  for (const auto& [name, text] : files) {
    auto document = syntax::Document::parse(text);
    const auto path = std::filesystem::path("/w") / name;
    documents.emplace(uriOf(name), document);
    texts[path] = {uriOf(name), 1, std::move(document)};
  }
  auto disk = std::make_shared<MemoryFiles>();
  auto graph = ide::graphOf(*disk, texts);
  snapshot = std::make_shared<ide::Snapshot>(std::move(disk), std::move(texts), std::move(graph));
}

std::vector<std::string> Desk::methodsOfPlaces() const {
  return select(registry, "textDocument/", false);
}
std::vector<std::string> Desk::methodsOfDocuments() const {
  return select(registry, "textDocument/", true);
}
std::vector<std::string> Desk::methodsOfWorkspaces() const {
  auto result = select(registry, "workspace/", false);
  std::erase(result, "workspace/executeCommand");
  return result;
}

const std::string& Desk::text(const std::string& file) const {
  return documents.at(uriOf(file)).text();
}

/// One for all methods: each takes the members that it knows.
Json Desk::params(const std::string& method, const std::string& file, syntax::Offset at) const {
  const auto& document = documents.at(uriOf(file));
  auto position = [&](syntax::Offset offset) -> Json {
    auto it = syntax::toEditor(document.text(), document.lines(), offset, client.encoding);
    return {{"line", it.line}, {"character", it.character}};
  };
  const bool whole = kOfDocuments.contains(method);
  const auto end = static_cast<syntax::Offset>(document.text().size());
  const Json range{{"start", position(whole ? 0 : at)}, {"end", position(whole ? end : at)}};
  return {{"textDocument", {{"uri", uriOf(file)}, {"version", 1}}},
          {"position", position(at)},
          {"positions", {position(at)}},
          {"range", range},
          {"ranges", {range}},
          {"context",
           {{"includeDeclaration", true},
            {"triggerKind", 1},
            {"isRetrigger", false},
            {"diagnostics", Json::array()},
            {"frameId", 0},
            {"stoppedLocation", range}}},
          {"newName", "renamed"},
          {"ch", ")"},
          {"options", {{"tabSize", 2}, {"insertSpaces", true}}},
          {"query", "ta"},
          {"previousResultId", ""},
          {"previousResultIds", Json::array()}};
}

Json Desk::raw(const std::string& method, const Json& params) const {
  const lsp::Request request{
      .params = params, .snapshot = *snapshot, .client = client, .cancellation = {}};
  auto answer = registry.methods.find(method)->second.handler(request);
  if (answer) return Json::parse(rpc::dump(*answer));
  if (answer.error().code == rpc::ErrorCode::InternalError)
    throw std::runtime_error("internal error: " + answer.error().message);
  return {{"error", answer.error().message}};
}

Json Desk::inBytes(const std::string& method, const Json& answer, const std::string& uri) const {
  const BytePlaces places(documents, client.encoding);
  if (!method.starts_with("textDocument/semanticTokens/")) {
    auto converted = places.convert(answer, uri);
    if (converted.is_object()) converted.erase("resultId"); // represents the unconverted answer
    return converted;
  }
  const auto& data = rpc::memberAt(answer, {"data"});
  return data.is_array() ? places.convertTokens(data, uri) : Json();
}

Json Desk::ask(const std::string& method, const std::string& file, syntax::Offset at) const {
  return inBytes(method, raw(method, params(method, file, at)), uriOf(file));
}

Json Desk::answer(const std::string& method, const std::string& file, const Json& more) const {
  auto members = params(method, file, 0);
  members.update(more);
  return raw(method, members);
}

Json Desk::inParts(const std::string& method, const std::string& file) const {
  const auto members = params(method, file, 0);
  lsp::Request request{
      .params = members, .snapshot = *snapshot, .client = client, .cancellation = {}};
  request.progress = std::make_shared<lsp::Progress>([](auto&&...) {}, Json(), Json("parts"));
  const auto answer = registry.methods.find(method)->second.handler(request);
  auto items = Json::array();
  if (!answer || !answer->is_array()) return "no list";
  for (const auto& item : *answer) items.push_back(Json::parse(rpc::dump(item)));
  return items;
}

void Desk::edit(const std::string& file, const syntax::TextEdit& edit) {
  auto& document = documents.at(uriOf(file));
  document = document.edit(edit.range, edit.text);
  const auto path = std::filesystem::path("/w") / file;
  auto texts = snapshot->open();
  texts[path].document = document;
  auto graph = ide::graphOf(MemoryFiles(), texts);
  snapshot = snapshot->with(std::move(texts), std::move(graph));
}

std::vector<std::pair<std::string, Json>>
Desk::followUps(const std::string& method, const std::string& file, syntax::Offset at) const {
  std::vector<std::pair<std::string, Json>> result;
  for (const auto& it : kFollowUps) {
    const std::string next(it.next);
    if (it.method != method || !registry.methods.contains(next)) continue;
    const auto answer = raw(method, params(method, file, at));
    const auto& items = itemsOf(answer);
    if (!items.is_array()) continue;
    for (const auto& item : items) {
      const auto& own = rpc::memberAt(item, {"uri"}); // positions refer to the item's target from
                                                      // here
      const auto uri = own.is_string() ? own.get<std::string>() : uriOf(file);
      const auto found = raw(next, it.asItem ? Json{{"item", item}} : item);
      result.emplace_back(next, inBytes(next, found, uri));
    }
  }
  return result;
}

} // namespace proskill::test
