#pragma once

#include "syntax/diagnostics/diagnostic.h"
#include "syntax/text/scan.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Recovery from missing or surplus parentheses and quotes. Finds where they are most likely
/// missing, reports this, and repairs the text in place without changing its length, so that the
/// rest can be parsed as intended.
namespace proskill::syntax {

/// Closes strings without a closing quote. Returns whether it changed the text.
bool recoverStrings(std::string& text, const Scan& scan, std::vector<Diagnostic>& diagnostics);

/// Returns the number of syntax errors in a text. Recovery prefers places for parentheses that make
/// this number small.
using Judge = std::function<std::size_t(std::string_view text)>;

/// Balances the parentheses. Returns whether it changed the text. \pre `scan` is the scan of `text`
bool recoverParentheses(std::string& text, const Scan& scan, const Judge& judge,
                        std::vector<Diagnostic>& diagnostics);

} // namespace proskill::syntax
