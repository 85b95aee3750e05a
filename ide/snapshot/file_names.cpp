#include "ide/snapshot/file_names.h"

namespace proskill::ide {

namespace {

using analysis::SymbolId;
using analysis::SymbolKind;

bool isSearched(SymbolKind kind) {
  switch (kind) {
  case SymbolKind::Parameter:
  case SymbolKind::PreconditionTag:
  case SymbolKind::InvariantTag:
  case SymbolKind::SuccessTag:
  case SymbolKind::FailureTag: return false;
  default: return true;
  }
}

} // namespace

/// Definitions at the top level come first, so that an owner has the same index in both tables.
/// Those without a name are kept for their contents.
FileNames::FileNames(const syntax::Document& document) {
  const auto program = analysis::load(analysis::NoFiles(), "file", document);
  const analysis::SymbolTable symbols(program);
  for (const auto& symbol : symbols.all()) {
    if (!isSearched(symbol.kind)) continue;
    const bool isInner = symbol.owner != analysis::kNoSymbol;
    names.push_back({symbol.kind, isInner, isInner ? symbol.owner : 0,
                     static_cast<std::uint32_t>(letters.size()),
                     static_cast<std::uint32_t>(symbol.name.size()), symbol.at.range});
    letters += symbol.name;
  }
  letters.shrink_to_fit();
  names.shrink_to_fit();
}

} // namespace proskill::ide
