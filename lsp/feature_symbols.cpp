#include "ide/symbols.h"
#include "lsp/convert.h"
#include "lsp/kept_parts.h"
#include "lsp/outline_json.h"
#include "lsp/symbol_kind.h"

namespace proskill::lsp {

namespace {

int kindOfEntry(const ide::OutlineEntry& entry) {
  return entry.isFile ? kFileSymbol : symbolKind(entry.kind);
}

/// The entries of a stretch.
struct SymbolPart {
  std::shared_ptr<const syntax::Tree> tree;
  MovableJson json;
};
using SymbolParts = Parts<SymbolPart>;

Answer documentSymbol(const Request& request, LastOfTexts<SymbolParts>& last) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const Converter convert(*view, request);
  const auto uri = convert.uri(view->file);
  const auto before = last.find(uri);
  EarlierParts<SymbolPart> earlier(before ? *before : SymbolParts());
  auto parts = std::make_shared<SymbolParts>();
  JsonWriter json;
  json.open('[');
  std::uint32_t line = 0;
  for (const auto& stretch : view->document().stretches()) {
    line = view->document().lines().position(stretch.range.begin, line).line;
    auto part = earlier.find(stretch.tree);
    if (!part) {
      JsonWriter mine;
      writeOutline(mine, ide::outline(*view, stretch.range), convert, view->file, kindOfEntry,
                   request);
      part = std::make_shared<const SymbolPart>(stretch.tree, MovableJson(std::move(mine), line));
    }
    part->json.write(json, line);
    parts->push_back(std::move(part));
  }
  last.keep(uri, std::move(parts));
  return listAnswer(request, json.close(']').str());
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
  const auto query = textIn(request.params, "query");
  if (!query) return std::unexpected(query.error());
  auto isCancelled = [&] { return request.cancellation.isCancelled(); };
  Json result = Json::array();
  for (const auto& found : ide::workspaceSymbols(request.snapshot, *query, isCancelled))
    result.push_back(symbolJson(found, request));
  return result;
}

} // namespace

void addSymbols(Registry& registry) {
  registry.capabilities["documentSymbolProvider"] = {{"label", "ProSkill"}};
  registry.capabilities["workspaceSymbolProvider"] = true;
  auto last = std::make_shared<LastOfTexts<SymbolParts>>();
  registry.add("textDocument/documentSymbol",
               [last](const Request& request) { return documentSymbol(request, *last); });
  registry.add("workspace/symbol", workspaceSymbol);
}

} // namespace proskill::lsp
