#include "ide/description/describe.h"
#include "ide/features/hierarchy.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/symbol_json.h"
#include "lsp/protocol/symbol_kind.h"

namespace proskill::lsp {

namespace {

using Links = std::vector<ide::Link>;

/// `CallHierarchyItem` and `TypeHierarchyItem` have the same form. The item contains the file of
/// the request, so that the next request is answered in the same program.
Json itemJson(const ide::View& view, analysis::SymbolId id, const Request& request) {
  const Converter convert(view, request);
  const auto& symbols = view.index().symbols();
  const auto& symbol = symbols[id];
  return {{"name", symbol.name},
          {"kind", symbolKind(symbol.kind)},
          {"detail", ide::signature(view, id)},
          {"uri", convert.uri(symbol.at.file)},
          {"range", convert.range({symbol.at.file, symbol.extent})},
          {"selectionRange", convert.range(symbol.at)},
          {"data", {{"uri", convert.uri(view.file)}, {"symbol", toJson(ide::keyOf(symbols, id))}}}};
}

Handler prepare(std::optional<analysis::SymbolId> (*find)(const ide::View&, syntax::Offset)) {
  return [find](const Request& request) -> Answer {
    auto at = cursor(request);
    if (!at) return std::unexpected(at.error());
    auto found = find(at->view, at->at);
    if (!found) return nullptr;
    return Json::array({itemJson(at->view, *found, request)});
  };
}

struct Asked {
  ide::View view;
  analysis::SymbolId symbol;
};

/// The symbol of an item; nullopt if the program no longer has it.
std::optional<Asked> askedFor(const Request& request) {
  const auto& data = rpc::memberAt(request.params, {"item", "data"});
  auto view = viewOfData(request, data);
  const auto key = symbolKey(rpc::memberAt(data, {"symbol"}));
  if (!view || !key) return std::nullopt;
  const auto symbol = ide::findSymbol(view->index().symbols(), *key);
  if (symbol == analysis::kNoSymbol) return std::nullopt;
  return Asked{std::move(*view), symbol};
}

Json rangesJson(const std::vector<analysis::Location>& places, const Converter& convert) {
  Json ranges = Json::array();
  for (auto place : places) ranges.push_back(convert.range(place));
  return ranges;
}

/// `end` is the answer's member for the item at the other end.
Handler calls(Links (*find)(const ide::View&, analysis::SymbolId), const char* end) {
  return [find, end](const Request& request) -> Answer {
    auto asked = askedFor(request);
    if (!asked) return nullptr;
    const Converter convert(asked->view, request);
    Json result = Json::array();
    for (const auto& link : find(asked->view, asked->symbol))
      result.push_back({{end, itemJson(asked->view, link.symbol, request)},
                        {"fromRanges", rangesJson(link.places, convert)}});
    return result;
  };
}

Handler types(analysis::SymbolKind of, bool isOf,
              Links (*find)(const ide::View&, analysis::SymbolId)) {
  return [of, isOf, find](const Request& request) -> Answer {
    auto asked = askedFor(request);
    if (!asked) return nullptr;
    Json result = Json::array();
    if ((asked->view.index().symbols()[asked->symbol].kind == of) != isOf) return result;
    for (const auto& link : find(asked->view, asked->symbol))
      result.push_back(itemJson(asked->view, link.symbol, request));
    return result;
  };
}

} // namespace

void addHierarchy(Registry& registry) {
  using enum analysis::SymbolKind;
  registry.capabilities["callHierarchyProvider"] = true;
  registry.capabilities["typeHierarchyProvider"] = true;
  registry.add("textDocument/prepareCallHierarchy", prepare(ide::skillAt));
  registry.add("callHierarchy/incomingCalls", calls(ide::incomingCalls, "from"));
  registry.add("callHierarchy/outgoingCalls", calls(ide::outgoingCalls, "to"));
  registry.add("textDocument/prepareTypeHierarchy", prepare(ide::userOrVariableAt));
  registry.add("typeHierarchy/subtypes", types(StateVariable, true, ide::usersOfVariable));
  registry.add("typeHierarchy/supertypes", types(StateVariable, false, ide::variablesOf));
}

} // namespace proskill::lsp
