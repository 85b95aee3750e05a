#pragma once

#include "ide/description/markup.h"
#include "syntax/diagnostics/diagnostic.h"

#include <string>

/// What a diagnostic is about, for a person who meets it for the first time.
namespace proskill::ide {

/// The message of a code, with `…` for what differs from place to place.
[[nodiscard]] std::string titleOf(const syntax::CodeInfo& code);
/// Its explanation as one line.
[[nodiscard]] std::string paragraphOf(const syntax::CodeInfo& code);
/// Title, explanation, and the example where there is one.
[[nodiscard]] Markup explanation(const syntax::CodeInfo& code);

} // namespace proskill::ide
