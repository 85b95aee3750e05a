#include "ide/verdicts/simulation.h"

namespace proskill::ide {

std::vector<TraceStep> inWords(const std::vector<verify::Choice>& choices,
                               const codegen::Model& model, syntax::Rational before) {
  std::vector<TraceStep> steps;
  for (const auto& choice : choices) {
    auto step = inWords(choice.step, model.provenance);
    step.earliest = {seconds(choice.earliest, choice.scale, model.unit), choice.afterEarliest};
    if (choice.latest)
      step.latest = {seconds(*choice.latest, choice.scale, model.unit), choice.beforeLatest};
    step.date = seconds(choice.step.date, choice.scale, model.unit);
    step.delay = difference(step.date, before);
    steps.push_back(std::move(step));
  }
  return steps;
}

} // namespace proskill::ide
