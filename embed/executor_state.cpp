#include "embed/executor.h"

#include "verify/compile/watch.h"
#include "verify/state/evaluate.h"

/// What can be read of an executor, and what its options mean.

using namespace proskill;
using embed::failed;
using embed::Failure;

namespace {

proskill_end endOf(runtime::End end) {
  using runtime::End;
  switch (end) {
  case End::Mission: return PROSKILL_MISSION_ENDED;
  case End::Until: return PROSKILL_TIME_LIMIT;
  case End::Stopped: return PROSKILL_ASKED_TO_END;
  case End::Abandoned: return PROSKILL_ABANDONED;
  case End::Stuck: return PROSKILL_STUCK;
  case End::NoTime: return PROSKILL_NO_TIME;
  case End::Failed: return PROSKILL_STEP_FAILED;
  case End::Lost: return PROSKILL_PLATFORM_LOST;
  }
  return PROSKILL_NOT_ENDED;
}

} // namespace

std::expected<proskill_executor::Settings, Failure>
proskill_executor::settingsOf(const proskill_options& options) {
  if (options.clock != PROSKILL_REAL_TIME && options.clock != PROSKILL_SIMULATED_TIME)
    return failed(PROSKILL_INVALID_ARGUMENT,
                  "`clock` must be PROSKILL_REAL_TIME or PROSKILL_SIMULATED_TIME");
  if (!(options.speed > 0 && options.speed <= 1e6))
    return failed(PROSKILL_INVALID_ARGUMENT, "`speed` must be more than 0, and at most a million");
  const auto until = embed::timeOf(options.until, "until");
  const auto grace = embed::timeOf(options.grace, "grace");
  if (!until) return std::unexpected(until.error());
  if (!grace) return std::unexpected(grace.error());
  Settings settings{.speed = options.speed, .isReal = options.clock == PROSKILL_REAL_TIME};
  settings.run.seed = options.seed;
  settings.run.grace = *grace;
  if (*until > 0) settings.run.until = *until;
  return settings;
}

proskill_phase proskill_executor::phase() const {
  if (!execution) return PROSKILL_READY;
  if (hasEnded) return PROSKILL_ENDED;
  return execution->isEnding() ? PROSKILL_ENDING : PROSKILL_RUNNING;
}

proskill_end proskill_executor::end() const {
  return hasEnded ? endOf(execution->result().end) : PROSKILL_NOT_ENDED;
}

const char* proskill_executor::outcome() const {
  return hasEnded ? execution->result().missionStatus.c_str() : "";
}

std::uint64_t proskill_executor::steps() const { return execution ? execution->result().steps : 0; }

std::uint64_t proskill_executor::faults() const { return execution ? execution->result().bad : 0; }

std::expected<const char*, Failure> proskill_executor::value(std::string_view name) {
  if (!execution) return failed(PROSKILL_WRONG_ORDER, "the run has not started");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < executable->shownVariables; ++i) {
    const auto& watched = executable->system.watched[i];
    names.push_back(watched.display);
    if (watched.display != name) continue;
    const auto* state = execution->state().state().data();
    shown = verify::shown(watched, verify::readCell(executable->system, watched.cell, state));
    return shown.c_str();
  }
  return embed::unknownName("value", name, names);
}

const char* proskill_executor::nameOfValue(std::size_t index) const {
  return index < executable->shownVariables ? executable->system.watched[index].display.c_str()
                                            : nullptr;
}
