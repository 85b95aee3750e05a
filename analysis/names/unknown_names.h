#pragma once

#include "analysis/names/index.h"

#include <vector>

namespace proskill::analysis {

/// Reports unknown names, each error once.
///
/// If a name is close to an existing one, each use is a separate misspelling with its own fix.
/// Otherwise the definition is missing or misspelt: one error, however often the name is used. It
/// is reported at the first use, with the other uses as related places. If the name of an unused
/// definition is close, the fix changes that. Names that a definition or file with syntax errors
/// would have defined are not reported, because their cause has been.
void reportUnknownNames(const Program& program, const Index& index,
                        const std::vector<UnknownName>& names, Findings& findings);

} // namespace proskill::analysis
