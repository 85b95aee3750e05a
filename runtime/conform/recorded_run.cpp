#include "runtime/conform/recorded_run.h"

#include "runtime/executor/description.h"

namespace proskill::runtime {

RecordedStep recorded(const Executable& executable, const Machine& machine,
                      verify::TransitionId step, Nanoseconds date) {
  auto described = lastStep(executable, machine, step);
  RecordedStep made{.date = date,
                    .what = {},
                    .changes = std::move(described.changes),
                    .stops = stoppingSkill(executable, machine)};
  const auto& origins = executable.model.provenance.origins;
  if (!described.origins.empty()) made.what = origins[described.origins.back()];
  return made;
}

} // namespace proskill::runtime
