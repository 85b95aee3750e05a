#include "lsp/protocol/folds_json.h"

#include "lsp/protocol/convert.h"

namespace proskill::lsp {

Answer foldsAnswer(const Request& request, const std::vector<ide::Fold>& folds) {
  rpc::JsonWriter json;
  json.open('[');
  for (const auto& fold : folds) {
    json.open('{').member("startLine", fold.firstLine).member("endLine", fold.lastLine);
    if (fold.kind == ide::FoldKind::Comment) json.member("kind", "comment");
    json.close('}');
  }
  return listAnswer(request, json.close(']').str());
}

} // namespace proskill::lsp
