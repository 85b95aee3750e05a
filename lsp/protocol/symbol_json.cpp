#include "lsp/protocol/symbol_json.h"

#include "lsp/protocol/convert.h"

namespace proskill::lsp {

Json toJson(const ide::SymbolKey& key) {
  rpc::JsonWriter json;
  write(json, key);
  return rpc::written(json.str());
}

void write(rpc::JsonWriter& json, const ide::SymbolKey& key) {
  json.open('{').member("kind", static_cast<int>(key.kind));
  json.member("name", key.name).member("owner", key.owner).close('}');
}

std::optional<ide::SymbolKey> symbolKey(const Json& json) {
  const auto& kind = rpc::memberAt(json, {"kind"});
  const auto& name = rpc::memberAt(json, {"name"});
  const auto& owner = rpc::memberAt(json, {"owner"});
  if (!kind.is_number_integer() || !name.is_string() || !owner.is_string()) return std::nullopt;
  const auto number = kind.get<std::int64_t>();
  if (number < 0 || number > static_cast<int>(analysis::SymbolKind::Label)) return std::nullopt;
  return ide::SymbolKey{static_cast<analysis::SymbolKind>(number), name, owner};
}

std::optional<ide::View> viewOfData(const Request& request, const Json& data) {
  const auto& uri = rpc::memberAt(data, {"uri"});
  if (!uri.is_string()) return std::nullopt;
  const auto path = request.snapshot.nameOf(pathOf(uri.get_ref<const std::string&>()));
  if (!request.snapshot.knows(path)) return std::nullopt;
  return request.snapshot.view(path);
}

} // namespace proskill::lsp
