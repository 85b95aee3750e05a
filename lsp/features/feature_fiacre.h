#pragma once

#include "lsp/protocol/registry.h"

namespace proskill::lsp {

/// What there is of Fiacre takes the place of what the methods of `textDocument` do for programs,
/// where the document is in Fiacre. \pre all others are added
void addFiacre(Registry& registry);

/// Whether it is said what a method of documents does for those in Fiacre: a test asks for each.
[[nodiscard]] bool isDecidedForFiacre(std::string_view method);

} // namespace proskill::lsp
