#pragma once

#include "rpc/rpc.h"
#include "syntax/document.h"
#include "syntax/text/position.h"

#include <optional>

namespace proskill::lsp {

/// The document after the `contentChanges` of `textDocument/didChange`, in their order; nothing
/// where one of them does not fit the text, unless a later one gives the whole text. However many
/// they are, the document is parsed but a few times: those that lie together are one edit.
[[nodiscard]] std::optional<syntax::Document>
changed(syntax::Document document, const Json& changes, syntax::Encoding encoding);

} // namespace proskill::lsp
