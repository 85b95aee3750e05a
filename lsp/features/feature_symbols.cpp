#include "ide/features/symbols.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/kept_parts.h"
#include "lsp/protocol/outline_json.h"
#include "lsp/protocol/symbol_kind.h"
#include "report/uri.h"

#include <algorithm>
#include <map>

namespace proskill::lsp {

namespace {

protocol::SymbolKind kindOfEntry(const ide::OutlineEntry& entry) {
  return entry.isFile ? protocol::SymbolKind::File : symbolKind(entry.kind);
}

/// The entries of a region.
struct SymbolPart {
  std::shared_ptr<const syntax::Tree> tree;
  rpc::MovableJson json;
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
  rpc::JsonWriter json;
  json.open('[');
  std::uint32_t line = 0;
  for (const auto& region : view->document().regions()) {
    line = view->document().lines().position(region.range.begin, line).line;
    auto part = earlier.find(region.tree);
    if (!part) {
      rpc::JsonWriter mine;
      writeOutline(mine, ide::outline(*view, region.range), convert, view->file, kindOfEntry,
                   request);
      part =
          std::make_shared<const SymbolPart>(region.tree, rpc::MovableJson(std::move(mine), line));
    }
    part->json.write(json, line);
    parts->push_back(std::move(part));
  }
  last.keep(uri, std::move(parts));
  return listAnswer(request, json.close(']').str());
}

/// SymbolPlaces for consecutive texts, each of which is read once.
class SymbolPlaces {
public:
  explicit SymbolPlaces(const Request& request) : request(request) {}

  Json location(const std::filesystem::path& file, syntax::Range range) {
    auto found = texts.find(file);
    if (found == texts.end())
      found = texts.try_emplace(file, request.snapshot.textOf(file).value_or("")).first;
    const auto& [text, lines] = found->second;
    auto position = [&](syntax::Offset at) {
      const auto end = static_cast<syntax::Offset>(text.size());
      const auto place = syntax::toEditor(text, lines, std::min(at, end), request.client.encoding);
      return Json{{"line", place.line}, {"character", place.character}};
    };
    const auto open = request.snapshot.open().find(file);
    return {{"uri", open == request.snapshot.open().end() ? report::toUri(file) : open->second.uri},
            {"range", {{"start", position(range.begin)}, {"end", position(range.end)}}}};
  }

private:
  struct Text {
    explicit Text(std::string read) : text(std::move(read)), lines(text) {}
    std::string text;
    syntax::LineIndex lines;
  };

  const Request& request;
  std::map<std::filesystem::path, Text> texts;
};

Json symbolJson(const ide::FoundSymbol& found, SymbolPlaces& places) {
  Json json{{"name", found.name},
            {"kind", symbolKind(found.kind)},
            {"location", places.location(found.file, found.at)}};
  if (found.owner) json["containerName"] = *found.owner;
  return json;
}

Answer workspaceSymbol(const Request& request) {
  const auto query = textIn(request.params, "query");
  if (!query) return std::unexpected(query.error());
  auto isCancelled = [&] { return request.cancellation.isCancelled(); };
  SymbolPlaces places(request);
  Json result = Json::array();
  for (const auto& found : ide::workspaceSymbols(request.snapshot, *query, isCancelled))
    result.push_back(symbolJson(found, places));
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
