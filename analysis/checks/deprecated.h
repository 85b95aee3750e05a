#pragma once

#include "analysis/names/findings.h"
#include "analysis/names/index.h"

#include <string_view>
#include <vector>

namespace proskill::analysis {

/// A name that its definition asks to use no more: a line of the comment directly above begins with
/// `Deprecated:`. Of several names that are defined in the line below the comment it is the first.
struct Deprecation {
  SymbolId symbol = kNoSymbol;
  std::string_view why; ///< the rest of the comment's line; may be empty
};

[[nodiscard]] std::vector<Deprecation> deprecations(const Program& program, const Index& index);

/// Tells each use of such a name outside of its own definition.
void reportDeprecated(const Program& program, const Index& index, Findings& findings);

} // namespace proskill::analysis
