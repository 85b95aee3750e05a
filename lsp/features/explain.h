#pragma once

#include "lsp/protocol/registry.h"

namespace proskill::lsp {

/// The command of a code action, for clients that do not implement it themselves.
inline constexpr const char* kExplainCommand = "proskill.explain";

/// The text of `proskill explain` for a code: `code`, `title`, `markdown` and `plain`.
[[nodiscard]] Answer explain(const Json& code);

void addExplain(Registry& registry);

} // namespace proskill::lsp
