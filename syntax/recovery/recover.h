#pragma once

#include "syntax/diagnostics/diagnostic.h"
#include "syntax/text/scan.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Finds where parentheses and quotes are missing or too many, reports that where a person would
/// look, and repairs the text in place, as long as it was, so that the rest of it can be read as it
/// was meant.
namespace proskill::syntax {

/// Closes the strings that have no closing quote. Returns whether anything was changed.
bool recoverStrings(std::string& text, const Scan& scan, std::vector<Diagnostic>& diagnostics);

/// How many things are wrong with the forms of a text: what a good place for a parenthesis makes
/// few.
using Judge = std::function<std::size_t(std::string_view text)>;

/// Makes the parentheses balance. Returns whether anything was changed. \pre `scan` is that of
/// `text`.
bool recoverParentheses(std::string& text, const Scan& scan, const Judge& judge,
                        std::vector<Diagnostic>& diagnostics);

} // namespace proskill::syntax
