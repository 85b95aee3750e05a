#pragma once

#include "analysis/names/symbols.h"
#include "syntax/tree/statements.h"

namespace proskill::analysis {

/// Visits statements at any depth.
using syntax::forEachStatement;

/// The body of a composite skill, or of an environment.
struct Body {
  const syntax::Block& block;
  FileId file;
  SymbolId owner;
};

} // namespace proskill::analysis
