#include "lsp/registry.h"

namespace proskill::lsp {

Registry allFeatures() {
  Registry registry;
  for (auto add : {addAutomaton, addCompletion, addDiagnostics, addHierarchy, addHints, addHover,
                   addLenses, addModel, addNavigation, addRename, addSymbols})
    add(registry);
  return registry;
}

} // namespace proskill::lsp
