#pragma once

#include "analysis/names/index.h"

#include <vector>

namespace proskill::analysis {

/// Tells the names that mean nothing, each mistake once.
///
/// Where a name is near to one that others use, each use is misspelt by itself and has an edit of
/// its own. Else the definition is missing or misspelt: that is one mistake, however often the name
/// is used. It is told at the first use, with the others as related places; where a definition that
/// nobody mentions is near, the edit is there. What a definition or a file would have defined that
/// was not read, which has been told, is no mistake of its own.
void reportUnknownNames(const Program& program, const Index& index,
                        const std::vector<UnknownName>& names, Findings& findings);

} // namespace proskill::analysis
