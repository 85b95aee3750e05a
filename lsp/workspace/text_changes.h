#pragma once

#include "rpc/rpc.h"
#include "syntax/document.h"
#include "syntax/text/position.h"

#include <optional>

namespace proskill::lsp {

/// The document after the `contentChanges` of `textDocument/didChange`, in their order; nothing
/// if one of them does not fit the text, unless a later one gives the whole text. Adjacent changes
/// are merged into one edit, so that the document is parsed only a few times.
[[nodiscard]] std::optional<syntax::Document>
changed(syntax::Document document, const Json& changes, syntax::Encoding encoding);

} // namespace proskill::lsp
