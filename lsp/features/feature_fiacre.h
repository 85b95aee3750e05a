#pragma once

#include "lsp/protocol/registry.h"

namespace proskill::lsp {

/// Replaces methods of `textDocument` by their Fiacre versions for documents in Fiacre. \pre all
/// other methods have been added
void addFiacre(Registry& registry);

/// Whether the behaviour of a document method is defined for Fiacre; a test checks this for each
/// method.
[[nodiscard]] bool isDecidedForFiacre(std::string_view method);

} // namespace proskill::lsp
