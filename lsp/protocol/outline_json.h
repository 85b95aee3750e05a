#pragma once

#include "lsp/protocol/convert.h"

#include <string_view>
#include <vector>

/// Outlines for any language: entries have a name, a detail, a range, a selection, and children.
namespace proskill::lsp {

/// The protocol's `DocumentSymbol`s. \param kindOf an entry's `SymbolKind`
template <class Entry, class KindOf>
void writeTrees(rpc::JsonWriter& json, const std::vector<Entry>& entries, const Converter& convert,
                analysis::FileId file, const KindOf& kindOf) {
  for (const auto& entry : entries) {
    json.open('{').member("name", entry.name).member("kind", kindOf(entry));
    convert.write(json.key("range"), file, entry.range);
    convert.write(json.key("selectionRange"), file, entry.selection);
    if (!entry.detail.empty()) json.member("detail", entry.detail);
    if (!entry.children.empty()) {
      json.key("children").open('[');
      writeTrees(json, entry.children, convert, file, kindOf);
      json.close(']');
    }
    json.close('}');
  }
}

/// The protocol's `SymbolInformation`s, for clients without support for trees.
template <class Entry, class KindOf>
void writeFlat(rpc::JsonWriter& json, const std::vector<Entry>& entries, const Converter& convert,
               analysis::FileId file, const KindOf& kindOf, std::string_view container = {}) {
  for (const auto& entry : entries) {
    json.open('{').member("name", entry.name).member("kind", kindOf(entry));
    convert.write(json.key("location"), {file, entry.range});
    if (!container.empty()) json.member("containerName", container);
    json.close('}');
    writeFlat(json, entry.children, convert, file, kindOf, entry.name);
  }
}

template <class Entry, class KindOf>
void writeOutline(rpc::JsonWriter& json, const std::vector<Entry>& entries,
                  const Converter& convert, analysis::FileId file, const KindOf& kindOf,
                  const Request& request) {
  if (request.client.hierarchicalSymbols)
    writeTrees(json, entries, convert, file, kindOf);
  else
    writeFlat(json, entries, convert, file, kindOf);
}

} // namespace proskill::lsp
