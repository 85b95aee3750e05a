#include "ide/lenses.h"
#include "ide/navigation.h"
#include "lsp/convert.h"
#include "lsp/symbol_json.h"

namespace proskill::lsp {

namespace {

using ide::LensKind;

Json command(std::string_view title, std::string_view name, Json arguments) {
  return {{"title", title}, {"command", name}, {"arguments", std::move(arguments)}};
}

/// The commands are the client's; their argument is that of the request that they lead to.
Json commandOf(const ide::Lens& lens, const analysis::Symbol& symbol, const std::string& uri) {
  Json subject{{"textDocument", {{"uri", uri}}}};
  switch (lens.kind) {
  case LensKind::References: return nullptr;
  case LensKind::Automaton:
    subject["kind"] = symbol.kind == analysis::SymbolKind::Skill ? "skill" : "sv";
    subject["name"] = symbol.name;
    return command(lens.title, "proskill.showAutomaton", Json::array({subject}));
  case LensKind::Verify:
    subject["names"] = Json::array({symbol.name});
    return command(lens.title, "proskill.verify", Json::array({subject}));
  case LensKind::Verdicts:
    if (lens.property.empty()) {
      subject["names"] = Json::array({symbol.name});
      return command(lens.title, "proskill.verify", Json::array({subject}));
    }
    subject["name"] = lens.property;
    return command(lens.title, "proskill.openTrace", Json::array({subject}));
  }
  return nullptr;
}

Answer codeLens(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const Converter convert(*view, request);
  const auto uri = convert.uri(view->file);
  const auto& symbols = view->index().symbols();
  Json result = Json::array();
  for (const auto& lens : ide::lenses(*view, *request.verdicts)) {
    Json json{{"range", convert.range(view->file, lens.at)}};
    if (auto what = commandOf(lens, symbols[lens.symbol], uri); !what.is_null())
      json["command"] = std::move(what);
    else
      json["data"] = {{"uri", uri}, {"symbol", toJson(ide::keyOf(symbols, lens.symbol))}};
    result.push_back(std::move(json));
  }
  return result;
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

/// A definition that is gone meanwhile has no references.
Answer resolve(const Request& request) {
  Json lens = request.params;
  const auto& data = memberAt(request.params, {"data"});
  const auto key = symbolKey(memberAt(data, {"symbol"}));
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
  registry.add("codeLens/resolve", resolve);
}

} // namespace proskill::lsp
