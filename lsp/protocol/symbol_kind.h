#pragma once

#include "analysis/names/symbols.h"
#include "lsp/protocol/numbers.h"

namespace proskill::lsp {

/// The protocol's `SymbolKind`.
[[nodiscard]] constexpr protocol::SymbolKind symbolKind(analysis::SymbolKind kind) {
  switch (kind) {
  case analysis::SymbolKind::StateVariable: return protocol::SymbolKind::Enum;
  case analysis::SymbolKind::Event: return protocol::SymbolKind::Event;
  case analysis::SymbolKind::Skill: return protocol::SymbolKind::Function;
  case analysis::SymbolKind::Resource: return protocol::SymbolKind::Object;
  case analysis::SymbolKind::Property: return protocol::SymbolKind::Property;
  case analysis::SymbolKind::Environment: return protocol::SymbolKind::Namespace;
  case analysis::SymbolKind::Constant: return protocol::SymbolKind::Constant;
  case analysis::SymbolKind::Value: return protocol::SymbolKind::EnumMember;
  case analysis::SymbolKind::Parameter: return protocol::SymbolKind::Variable;
  case analysis::SymbolKind::PreconditionTag:
  case analysis::SymbolKind::InvariantTag: return protocol::SymbolKind::Boolean;
  case analysis::SymbolKind::SuccessTag:
  case analysis::SymbolKind::FailureTag: return protocol::SymbolKind::Constant;
  case analysis::SymbolKind::Label: return protocol::SymbolKind::Key;
  }
  return protocol::SymbolKind::Variable;
}

} // namespace proskill::lsp
