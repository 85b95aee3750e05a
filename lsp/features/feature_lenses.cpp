#include "ide/features/lenses.h"
#include "ide/features/navigation.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/symbol_json.h"

namespace proskill::lsp {

namespace {

using ide::LensKind;

/// What to verify; empty: everything.
std::string_view nameOf(const ide::Lens& lens, const ide::View& view) {
  return lens.symbol == analysis::kNoSymbol ? std::string_view(lens.name)
                                            : view.index().symbols()[lens.symbol].name;
}

/// Commands belong to the client; their argument is that of the request that they send.
void writeCommand(rpc::JsonWriter& json, const ide::Lens& lens, const ide::View& view,
                  std::string_view uri) {
  auto begin = [&](const char* name) {
    json.key("command").open('{').member("title", lens.title).member("command", name);
    json.key("arguments").open('[').open('{');
    json.key("textDocument").open('{').member("uri", uri).close('}');
  };
  if (lens.kind == LensKind::Automaton) {
    const auto& symbol = view.index().symbols()[lens.symbol];
    begin("proskill.showAutomaton");
    json.member("kind", symbol.kind == analysis::SymbolKind::Skill ? "skill" : "sv");
    json.member("name", symbol.name);
  } else if (lens.property.empty()) {
    begin("proskill.verify");
    json.key("names").open('[');
    if (const auto name = nameOf(lens, view); !name.empty()) json.value(name);
    json.close(']');
  } else {
    begin("proskill.openTrace");
    json.member("name", lens.property);
  }
  json.close('}').close(']').close('}');
}

/// References are counted by `resolve`.
void writeData(rpc::JsonWriter& json, const ide::View& view, analysis::SymbolId symbol,
               std::string_view uri) {
  json.key("data").open('{').member("uri", uri);
  write(json.key("symbol"), ide::keyOf(view.index().symbols(), symbol));
  json.close('}');
}

Answer codeLens(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const Converter convert(*view, request);
  const auto uri = convert.uri(view->file);
  rpc::JsonWriter json;
  json.open('[');
  for (const auto& lens : ide::lenses(*view, *request.verdicts)) {
    convert.write(json.open('{').key("range"), view->file, lens.at);
    if (lens.kind == LensKind::References)
      writeData(json, *view, lens.symbol, uri);
    else
      writeCommand(json, lens, *view, uri);
    json.close('}');
  }
  return listAnswer(request, json.close(']').str());
}

Json command(std::string_view title, std::string_view name, Json arguments) {
  return {{"title", title}, {"command", name}, {"arguments", std::move(arguments)}};
}

Json referencesCommand(const ide::View& view, analysis::SymbolId id, const Request& request) {
  const Converter convert(view, request);
  const auto& symbol = view.index().symbols()[id];
  Json locations = Json::array();
  for (const auto& place : view.index().occurrencesOf(id))
    if (place.role != analysis::Role::Definition) locations.push_back(convert.location(place.at));
  const auto title = ide::referencesTitle(locations.size());
  return command(
      title, "proskill.showReferences",
      Json::array({convert.uri(symbol.at.file),
                   convert.position(symbol.at.file, symbol.at.range.begin), std::move(locations)}));
}

/// A definition that no longer exists has no references.
Answer resolveLens(const Request& request) {
  Json lens = request.params;
  const auto& data = rpc::memberAt(request.params, {"data"});
  const auto key = symbolKey(rpc::memberAt(data, {"symbol"}));
  auto view = viewOfData(request, data);
  if (!view || !key) return lens;
  const auto id = ide::findSymbol(view->index().symbols(), *key);
  lens["command"] = id == analysis::kNoSymbol ? command(ide::referencesTitle(0), "", Json::array())
                                              : referencesCommand(*view, id, request);
  return lens;
}

} // namespace

void addLenses(Registry& registry) {
  registry.capabilities["codeLensProvider"] = {{"resolveProvider", true}};
  registry.add("textDocument/codeLens", codeLens);
  registry.add("codeLens/resolve", resolveLens);
}

} // namespace proskill::lsp
