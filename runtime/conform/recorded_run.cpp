#include "runtime/conform/recorded_run.h"

#include "runtime/executor/description.h"

namespace proskill::runtime {

RecordedStep recorded(const Executable& executable, const Machine& machine,
                      verify::TransitionId step, Nanoseconds date) {
  auto described = lastStep(executable, machine, step);
  const auto stops = stoppingAction(executable, machine);
  RecordedStep made{.date = date,
                    .what = {},
                    .changes = std::move(described.changes),
                    .stops = stops ? executable.model.performed[*stops].skill : "",
                    .message = printedMessage(executable, machine).value_or("")};
  const auto& origins = executable.model.provenance.origins;
  if (!described.origins.empty()) made.what = origins[described.origins.back()];
  return made;
}

RecordedCall recorded(const Executable& executable, const Start& start, Nanoseconds date,
                      std::size_t after) {
  RecordedCall made{.after = after,
                    .date = date,
                    .skill = executable.model.performed[start.action].skill,
                    .command = "",
                    .arguments = {}};
  if (!start.call) return made;
  made.command = start.call->command;
  made.arguments = start.call->arguments;
  return made;
}

bool KeptRun::onHead(const RecordedHead& head) {
  run.head = head;
  return true;
}

bool KeptRun::onStep(const RecordedStep& step) {
  run.steps.push_back(step);
  return true;
}

bool KeptRun::onCall(const RecordedCall& call) {
  run.calls.push_back(call);
  return true;
}

bool replay(const RecordedRun& run, RunSink& to) {
  return to.onHead(run.head) && replaySteps(run, to);
}

bool replaySteps(const RecordedRun& run, RunSink& to) {
  auto call = run.calls.begin();
  for (std::size_t i = 0; i <= run.steps.size(); ++i) {
    for (; call != run.calls.end() && call->after <= i; ++call)
      if (!to.onCall(*call)) return false;
    if (i < run.steps.size() && !to.onStep(run.steps[i])) return false;
  }
  return true;
}

} // namespace proskill::runtime
