#include "codegen/model.h"
#include "codegen/process/component.h"
#include "codegen/process/executed_action.h"
#include "codegen/process/state_variables.h"
#include "codegen/property/checks.h"
#include "codegen/term/annotate.h"
#include "codegen/term/tina_edition.h"
#include "codegen/term/watched.h"

namespace proskill::codegen {

std::expected<PlatformInterface, GenerationError>
platformInterface(const analysis::Program& program, const Options& options) {
  const auto plan = makeGenerationPlan(program, options);
  if (!plan) return std::unexpected(plan.error());
  PlatformInterface made{{}, signalsOf(program, *plan)};
  for (const auto& skill : plan->skills) {
    if (skill.body) continue;
    auto& performed = made.performed.emplace_back();
    performed.skill = skill.name();
    performed.results = resultsOf(skill);
  }
  return made;
}

std::expected<Model, GenerationError> generate(const analysis::Program& program,
                                               const Options& options) {
  auto plan = makeGenerationPlan(program, options);
  if (!plan) return std::unexpected(std::move(plan.error()));
  const auto times = Times::of(program, options);
  if (!times) return std::unexpected(times.error());
  Names names(program, *plan);
  Context context{.program = program,
                  .options = options,
                  .plan = std::move(*plan),
                  .times = *times,
                  .names = std::move(names),
                  .origins = Origins(program),
                  .results = {},
                  .alarmed = {},
                  .invariantActive = {},
                  .reader = {},
                  .writtenIn = nullptr,
                  .arguments = {},
                  .performed = {},
                  .alarms = {},
                  .messages = {}};
  if (context.isPerformed()) context.arguments = CallTable(program, context.plan);
  Model model;
  model.fiacre = buildProgram(context);
  annotate(model.fiacre, context.origins.provenance);
  if (context.hasInitialChoice()) model.beginPort = beginPort(context);
  model.obliged = obligedProcesses(context);
  model.unit = times->unit();
  if (context.isPerformed()) model.actionCalls = context.arguments.actions();
  if (context.isExecuted()) tellExecutor(context, model);
  if (context.plan.mission) model.mainSkill = context.plan.mission->name();
  if (context.isExecuted()) addProperties(context, model);
  if (!context.isPerformed()) addChecks(context, model);
  if (options.edition == Edition::Tina || context.isRuntime()) {
    removeIdleProcesses(model.fiacre);
    coerceNumbers(model.fiacre);
  }
  context.origins.provenance.watched = watchedVariables(context);
  model.provenance = std::move(context.origins.provenance);
  return model;
}

} // namespace proskill::codegen
