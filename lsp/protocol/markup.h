#pragma once

#include "ide/description/markup.h"
#include "rpc/rpc.h"

namespace proskill::lsp {

/// The protocol's `MarkupContent`.
[[nodiscard]] inline Json markupContent(const ide::Markup& text, bool markdown) {
  return {{"kind", markdown ? "markdown" : "plaintext"},
          {"value", markdown ? text.markdown() : text.plain()}};
}

} // namespace proskill::lsp
