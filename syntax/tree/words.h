#pragma once

#include "syntax/diagnostics/diagnostic.h"
#include "syntax/tree/tree.h"

#include <string>
#include <vector>

/// Diagnostics about single bytes and words, independent of their context.
namespace proskill::syntax {

/// Reports bytes that a text must not contain (invalid UTF-8, control characters) and overwrites
/// them with kNoText.
void cleanBytes(std::string& text, std::vector<Diagnostic>& diagnostics);
inline constexpr char kNoText = '\x1a';

/// Reports bad names, stray characters, unknown escapes, numbers too large.
void checkWords(std::string_view text, const Tree& tree, std::vector<Diagnostic>& diagnostics);

} // namespace proskill::syntax
