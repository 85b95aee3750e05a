#pragma once

#include "syntax/diagnostics/diagnostic.h"
#include "syntax/tree/tree.h"

#include <string>
#include <vector>

/// What is wrong with single bytes and words, whatever they stand in.
namespace proskill::syntax {

/// Reports bytes that no text has (bad UTF-8, control characters) and overwrites them by kNoText.
void cleanBytes(std::string& text, std::vector<Diagnostic>& diagnostics);
inline constexpr char kNoText = '\x1a';

/// Reports bad names, stray characters, unknown escapes, numbers too large.
void checkWords(std::string_view text, const Tree& tree, std::vector<Diagnostic>& diagnostics);

} // namespace proskill::syntax
