#pragma once

#include "analysis/names/symbols.h"

namespace proskill::lsp {

/// The protocol's `SymbolKind`.
[[nodiscard]] constexpr int symbolKind(analysis::SymbolKind kind) {
  switch (kind) {
  case analysis::SymbolKind::StateVariable: return 10; // enum
  case analysis::SymbolKind::Event: return 24;
  case analysis::SymbolKind::Skill: return 12;      // function
  case analysis::SymbolKind::Resource: return 19;   // object
  case analysis::SymbolKind::Property: return 7;    // property
  case analysis::SymbolKind::Environment: return 3; // namespace
  case analysis::SymbolKind::Value: return 22;      // enum member
  case analysis::SymbolKind::Parameter: return 13;  // variable
  case analysis::SymbolKind::PreconditionTag:
  case analysis::SymbolKind::InvariantTag: return 17; // boolean
  case analysis::SymbolKind::SuccessTag:
  case analysis::SymbolKind::FailureTag: return 14; // constant
  case analysis::SymbolKind::Label: return 20;      // key
  }
  return 13;
}
constexpr int kFileSymbol = 1;

} // namespace proskill::lsp
