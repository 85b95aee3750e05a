#include "lsp/registry.h"

namespace proskill::lsp {

Registry allFeatures() {
  Registry registry;
  for (auto add : {addCompletion, addDiagnostics, addFormatting, addHierarchy, addHints, addHover,
                   addLenses, addNavigation, addRename, addSymbols})
    add(registry);
  return registry;
}

} // namespace proskill::lsp
