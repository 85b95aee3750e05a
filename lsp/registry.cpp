#include "lsp/registry.h"

#include "lsp/explain.h"
#include "lsp/feature_fiacre.h"

namespace proskill::lsp {

Registry allFeatures() {
  Registry registry;
  for (auto add : {addActions, addAutomaton, addCompletion, addDiagnostics, addExplain,
                   addFormatting, addHierarchy, addHints, addHover, addLenses, addModel,
                   addNavigation, addRename, addStructure, addSymbols, addTokens})
    add(registry);
  addFiacre(registry);
  return registry;
}

} // namespace proskill::lsp
