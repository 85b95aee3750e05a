#pragma once

#include "analysis/names/findings.h"
#include "analysis/names/index.h"

#include <string_view>
#include <vector>

namespace proskill::analysis {

/// A name marked as deprecated: a line of the comment directly above its definition begins with
/// `Deprecated:`. If the line below the comment defines several names, the first one is meant.
struct Deprecation {
  SymbolId symbol = kNoSymbol;
  std::string_view why; ///< the rest of this line; may be empty
};

[[nodiscard]] std::vector<Deprecation> deprecations(const Program& program, const Index& index);

/// Reports each use of a deprecated name outside of its own definition.
void reportDeprecated(const Program& program, const Index& index, Findings& findings);

} // namespace proskill::analysis
