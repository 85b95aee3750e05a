#pragma once

#include "syntax/document.h"
#include "syntax/text/edit.h"

#include <span>
#include <string>

namespace proskill::cli {

/// What edits do to a file, as `diff -u` prints it; empty where there are none.
[[nodiscard]] std::string unifiedDiff(const std::string& file, const syntax::Document& before,
                                      std::span<const syntax::TextEdit> edits);

} // namespace proskill::cli
