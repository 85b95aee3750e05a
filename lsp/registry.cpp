#include "lsp/registry.h"

namespace proskill::lsp {

Registry allFeatures() {
  Registry registry;
  for (auto add : {addCompletion, addDiagnostics, addNavigation}) add(registry);
  return registry;
}

} // namespace proskill::lsp
