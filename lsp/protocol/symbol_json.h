#pragma once

#include "ide/snapshot/symbol_key.h"
#include "lsp/protocol/registry.h"
#include "rpc/json_writer.h"

#include <optional>

/// Symbols on their way through the client and back: in the `data` of items that are resolved.
namespace proskill::lsp {

[[nodiscard]] Json toJson(const ide::SymbolKey& key);
/// The same, written.
void write(rpc::JsonWriter& json, const ide::SymbolKey& key);
/// Nothing if it is not a key.
[[nodiscard]] std::optional<ide::SymbolKey> symbolKey(const Json& json);

/// The view of the file that `data.uri` names, where it is known; the client may have kept the data
/// for long.
[[nodiscard]] std::optional<ide::View> viewOfData(const Request& request, const Json& data);

} // namespace proskill::lsp
