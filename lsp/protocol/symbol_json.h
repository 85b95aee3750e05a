#pragma once

#include "ide/snapshot/symbol_key.h"
#include "lsp/protocol/registry.h"
#include "rpc/json_writer.h"

#include <optional>

/// Symbols in the `data` of items that the client sends back to be resolved.
namespace proskill::lsp {

[[nodiscard]] Json toJson(const ide::SymbolKey& key);
/// The same, written as text.
void write(rpc::JsonWriter& json, const ide::SymbolKey& key);
/// Nothing if it is not a key.
[[nodiscard]] std::optional<ide::SymbolKey> symbolKey(const Json& json);

/// The view of the file in `data.uri`, if it is known; the client may have kept the data for a long
/// time.
[[nodiscard]] std::optional<ide::View> viewOfData(const Request& request, const Json& data);

} // namespace proskill::lsp
