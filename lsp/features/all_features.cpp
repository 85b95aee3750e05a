#include "lsp/protocol/registry.h"

#include "lsp/features/explain.h"
#include "lsp/features/feature_fiacre.h"

namespace proskill::lsp {

Registry allFeatures() {
  Registry registry;
  for (auto add :
       {addActions, addAutomaton, addCompletion, addDiagnostics, addExplain, addFormatting,
        addHierarchy, addHints, addHover, addLenses, addModel, addNavigation, addRecording,
        addRename, addSimulation, addStructure, addSymbols, addTokens})
    add(registry);
  addFiacre(registry);
  return registry;
}

} // namespace proskill::lsp
