#include "analysis/checks/checks.h"

#include "analysis/names/expressions.h"

namespace proskill::analysis {

void checkEvents(Context& context) {
  context.each(context.program.events, [&](const auto& event) {
    Expressions(context, event.file).effects(event->effects);
  });
}

} // namespace proskill::analysis
