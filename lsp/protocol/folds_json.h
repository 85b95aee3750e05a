#pragma once

#include "ide/features/structure.h"
#include "lsp/protocol/registry.h"

namespace proskill::lsp {

/// The protocol's `FoldingRange[]`: whole lines, which every client can fold.
[[nodiscard]] Answer foldsAnswer(const Request& request, const std::vector<ide::Fold>& folds);

} // namespace proskill::lsp
