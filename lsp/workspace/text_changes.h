#pragma once

#include "rpc/rpc.h"
#include "syntax/document.h"
#include "syntax/text/position.h"

#include <optional>

namespace proskill::lsp {

/// Whether the text after the changes does not depend on the text before: one of them replaces it
/// as a whole.
[[nodiscard]] bool replaceWhole(const Json& changes);

/// Applies the `contentChanges` of `textDocument/didChange` in order. Nothing if one of them does
/// not fit the text, unless a later one replaces the whole text. Adjacent changes are merged into
/// one edit, so that the document is parsed only a few times.
[[nodiscard]] std::optional<syntax::Document>
changed(syntax::Document document, const Json& changes, syntax::Encoding encoding);

} // namespace proskill::lsp
