#pragma once

#include "lsp/protocol/registry.h"

namespace proskill::lsp {

/// The command of a code action, for clients that have none of that name themselves.
inline constexpr const char* kExplainCommand = "proskill.explain";

/// What `proskill explain` says of a code: `code`, `title`, `markdown` and `plain`.
[[nodiscard]] Answer explain(const Json& code);

void addExplain(Registry& registry);

} // namespace proskill::lsp
