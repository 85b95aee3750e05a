#include "ide/description/explanation.h"
#include "lsp/features/explain.h"
#include "lsp/protocol/convert.h"

#include <fmt/format.h>

namespace proskill::lsp {

Answer explain(const Json& code) {
  if (!code.is_string())
    return std::unexpected(rpc::RpcError{rpc::ErrorCode::InvalidParams, "`code` is missing"});
  const auto& id = code.get_ref<const std::string&>();
  const auto* found = syntax::findCode(id);
  if (!found) return std::unexpected(requestFailed(fmt::format("there is no code `{}`", id)));
  const auto text = ide::explanation(*found);
  return Json{{"code", found->id},
              {"title", ide::titleOf(*found)},
              {"markdown", text.markdown()},
              {"plain", text.plain()}};
}

void addExplain(Registry& registry) {
  registry.add("proskill/explain", [](const Request& request) {
    return explain(rpc::memberAt(request.params, {"code"}));
  });
}

} // namespace proskill::lsp
