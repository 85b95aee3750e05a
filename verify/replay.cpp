#include "verify/replay.h"

#include "verify/evaluate.h"
#include "verify/simulator.h"

#include <utility>

namespace proskill::verify {

namespace {

bool shows(const System& system, const Goal& goal, const Concrete& before, const Concrete& after,
           const StepLog& log) {
  Bits events;
  for (auto event : log.events) events.insert(event);
  if (goal.kind == GoalKind::Events) return events.meets(goal.events);
  const Moment step{before.state.data(), after.state.data(), &events};
  const Moment still{after.state.data(), nullptr, nullptr};
  return holdsAt(system, goal.condition, still) || holdsAt(system, goal.condition, step);
}

} // namespace

std::string replay(const System& system, const Goal& goal, const std::vector<TransitionId>& steps,
                   const Dating& dating) {
  Simulator simulator(system, dating.scale);
  Concrete now = simulator.start();
  Concrete before = now;
  StepLog log;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::int64_t date = dating.steps[i].date;
    const std::string where = "step " + std::to_string(i + 1) + " ";
    if (date < last || !simulator.mayWait(now, date)) return where + "comes too late";
    if (!simulator.isRipe(now, steps[i], date)) return where + "comes too early";
    auto next = simulator.take(now, steps[i], date, log);
    if (!next) return where + "is not possible";
    before = std::exchange(now, std::move(*next));
    last = date;
  }
  if (dating.end < last || !simulator.mayWait(now, dating.end)) return "the end comes too late";
  switch (goal.kind) {
  case GoalKind::Deadlock:
    if (!now.since.empty()) return "something is still possible at the end";
    return holdsAt(system, goal.condition, {now.state.data()}) ? "the end is one that is allowed"
                                                               : "";
  case GoalKind::Stuck:
    return simulator.canGoOn(now, dating.end) ? "time can still go on at the end" : "";
  default: break;
  }
  if (steps.empty() && goal.initially) return {};
  return shows(system, goal, before, now, log) ? "" : "the end does not show what was asked for";
}

} // namespace proskill::verify
