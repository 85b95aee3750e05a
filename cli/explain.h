#pragma once

#include "syntax/diagnostic.h"

#include <string>

namespace CLI {
class App;
}

namespace proskill::cli {

/// The message of a code, with `…` for what differs from place to place.
[[nodiscard]] std::string titleOf(const syntax::CodeInfo& code);
/// Its explanation as one line.
[[nodiscard]] std::string paragraphOf(const syntax::CodeInfo& code);

/// `proskill explain`: exit 0, or 2 where there is no such code.
void addExplain(CLI::App& app, int& exitCode);

} // namespace proskill::cli
