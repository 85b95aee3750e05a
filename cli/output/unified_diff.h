#pragma once

#include "syntax/document.h"
#include "syntax/text/edit.h"

#include <span>
#include <string>

namespace proskill::cli {

/// The effect of edits on a file, as `diff -u` prints it; empty if there are no edits.
[[nodiscard]] std::string unifiedDiff(const std::string& file, const syntax::Document& before,
                                      std::span<const syntax::TextEdit> edits);

} // namespace proskill::cli
