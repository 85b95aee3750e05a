#include "ide/features/structure.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/folds_json.h"

namespace proskill::lsp {

namespace {

Answer foldingRange(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  return foldsAnswer(request, ide::folds(view->document()));
}

Answer selectionRange(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  if (!request.params.contains("positions") || !request.params["positions"].is_array())
    return std::unexpected(rpc::RpcError{rpc::ErrorCode::InvalidParams, "`positions` is missing"});
  const Converter convert(*view, request);
  Json result = Json::array();
  for (const auto& position : request.params["positions"]) {
    auto at = offsetOf(*view, position, request.client.encoding);
    if (!at) return std::unexpected(at.error());
    Json nested;
    auto ranges = ide::selections(view->document(), *at);
    for (auto range = ranges.rbegin(); range != ranges.rend(); ++range) {
      Json outer = std::move(nested);
      nested = {{"range", convert.range(view->file, *range)}};
      if (!outer.is_null()) nested["parent"] = std::move(outer);
    }
    result.push_back(std::move(nested));
  }
  return result;
}

Answer documentLink(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const Converter convert(*view, request);
  Json result = Json::array();
  for (const auto& link : ide::links(view->program().files[view->file].path, view->document())) {
    result.push_back({{"range", convert.range(view->file, link.range)},
                      {"target", uriOf(link.target, request.snapshot)},
                      {"tooltip", "Open " + link.target.filename().string()}});
  }
  return result;
}

} // namespace

void addStructure(Registry& registry) {
  registry.add("textDocument/foldingRange", foldingRange);
  registry.add("textDocument/selectionRange", selectionRange);
  registry.add("textDocument/documentLink", documentLink);
  registry.capabilities["foldingRangeProvider"] = true;
  registry.capabilities["selectionRangeProvider"] = true;
  registry.capabilities["documentLinkProvider"] = {{"resolveProvider", false}};
}

} // namespace proskill::lsp
