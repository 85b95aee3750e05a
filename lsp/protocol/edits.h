#pragma once

#include "lsp/protocol/convert.h"
#include "syntax/text/edit.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace proskill::lsp {

/// The protocol's `TextEdit[]` for edits of one file.
[[nodiscard]] Json textEdits(const Converter& convert, analysis::FileId file,
                             std::span<const syntax::TextEdit> edits);

using FileEdits = std::map<std::filesystem::path, std::vector<syntax::TextEdit>>;

/// A `WorkspaceEdit` for several files, in one of the protocol's two formats.
[[nodiscard]] Json workspaceEdit(const FileEdits& edits, const Request& request);

/// The same for writing one text at several places.
[[nodiscard]] Json
workspaceEdit(const std::map<std::filesystem::path, std::vector<syntax::Range>>& places,
              const std::string& text, const Request& request);

} // namespace proskill::lsp
