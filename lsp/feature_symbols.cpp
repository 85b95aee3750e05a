#include "ide/symbols.h"
#include "lsp/convert.h"
#include "lsp/symbol_kind.h"

namespace proskill::lsp {

namespace {

int kindOf(const ide::OutlineEntry& entry) {
  return entry.isFile ? kFileSymbol : symbolKind(entry.kind);
}

void writeTree(JsonWriter& json, const ide::OutlineEntry& entry, const Converter& convert,
               analysis::FileId file) {
  json.open('{').member("name", entry.name).member("kind", kindOf(entry));
  convert.write(json.key("range"), file, entry.range);
  convert.write(json.key("selectionRange"), file, entry.selection);
  if (!entry.detail.empty()) json.member("detail", entry.detail);
  if (!entry.children.empty()) {
    json.key("children").open('[');
    for (const auto& child : entry.children) writeTree(json, child, convert, file);
    json.close(']');
  }
  json.close('}');
}

/// For clients that know no trees: `SymbolInformation`.
void addFlat(Json& list, const ide::OutlineEntry& entry, const std::string& container,
             const Converter& convert, analysis::FileId file) {
  Json json{{"name", entry.name},
            {"kind", kindOf(entry)},
            {"location", convert.location({file, entry.range})}};
  if (!container.empty()) json["containerName"] = container;
  list.push_back(std::move(json));
  for (const auto& child : entry.children) addFlat(list, child, entry.name, convert, file);
}

Answer documentSymbol(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const Converter convert(*view, request);
  Json result = Json::array();
  for (const auto& entry : ide::outline(*view)) {
    if (!request.client.hierarchicalSymbols) {
      addFlat(result, entry, {}, convert, view->file);
      continue;
    }
    JsonWriter json;
    writeTree(json, entry, convert, view->file);
    result.push_back(written(json.str()));
  }
  return result;
}

Json symbolJson(const ide::FoundSymbol& found, const Request& request) {
  const Converter convert(found.owner->program, request.snapshot.open(), request.client.encoding);
  const auto& symbols = found.owner->analysis.index.symbols();
  const auto& symbol = symbols[found.symbol];
  Json json{{"name", symbol.name},
            {"kind", symbolKind(symbol.kind)},
            {"location", convert.location(symbol.at)}};
  if (symbol.owner != analysis::kNoSymbol) json["containerName"] = symbols[symbol.owner].name;
  return json;
}

Answer workspaceSymbol(const Request& request) {
  const auto& query = memberAt(request.params, {"query"});
  if (!query.is_string())
    return std::unexpected(RpcError{ErrorCode::InvalidParams, "`query` is missing"});
  auto isCancelled = [&] { return request.cancellation.isCancelled(); };
  Json result = Json::array();
  for (const auto& found :
       ide::workspaceSymbols(request.snapshot, query.get_ref<const std::string&>(), isCancelled))
    result.push_back(symbolJson(found, request));
  return result;
}

} // namespace

void addSymbols(Registry& registry) {
  registry.capabilities["documentSymbolProvider"] = {{"label", "ProSkill"}};
  registry.capabilities["workspaceSymbolProvider"] = true;
  registry.add("textDocument/documentSymbol", documentSymbol);
  registry.add("workspace/symbol", workspaceSymbol);
}

} // namespace proskill::lsp
