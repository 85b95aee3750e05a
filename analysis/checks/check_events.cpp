#include "analysis/checks/checks.h"

#include "analysis/names/expressions.h"
#include "syntax/diagnostics/codes.h"

namespace proskill::analysis {

void checkEvents(Context& context) {
  context.each(context.program.events, [&](const auto& event) {
    Expressions expressions(context, event.file);
    if (event->guard) expressions.condition(*event->guard);
    expressions.effects(event->effects);
    if (event->guard && event->every)
      context.findings.report(syntax::Code::EveryWithGuard, event.at(event->guard->range),
                              event.name());
  });
}

} // namespace proskill::analysis
