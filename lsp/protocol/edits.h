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

/// A `WorkspaceEdit` of files, in either of the protocol's two ways.
[[nodiscard]] Json workspaceEdit(const FileEdits& edits, const Request& request);

/// The same where one text is written at places of files.
[[nodiscard]] Json
workspaceEdit(const std::map<std::filesystem::path, std::vector<syntax::Range>>& places,
              const std::string& text, const Request& request);

} // namespace proskill::lsp
