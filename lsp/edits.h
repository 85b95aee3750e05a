#pragma once

#include "lsp/convert.h"
#include "syntax/edit.h"

#include <span>

namespace proskill::lsp {

/// The protocol's `TextEdit[]` for edits of one file.
[[nodiscard]] Json textEdits(const Converter& convert, analysis::FileId file,
                             std::span<const syntax::TextEdit> edits);

} // namespace proskill::lsp
