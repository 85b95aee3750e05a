#include "analysis/checks.h"

#include "analysis/expressions.h"

namespace proskill::analysis {

void checkEvents(Context& context) {
  for (const auto& event : context.program.events.all)
    Expressions(context, event.file).effects(event->effects);
}

} // namespace proskill::analysis
