#pragma once

#include "ide/description/markup.h"
#include "syntax/diagnostics/diagnostic.h"

#include <string>

/// Explanations of diagnostics for users.
namespace proskill::ide {

/// The message of a code with `…` for its arguments.
[[nodiscard]] std::string titleOf(const syntax::CodeInfo& code);
/// The explanation as one line.
[[nodiscard]] std::string paragraphOf(const syntax::CodeInfo& code);
/// Title, explanation and, if there is one, the example.
[[nodiscard]] Markup explanation(const syntax::CodeInfo& code);

} // namespace proskill::ide
