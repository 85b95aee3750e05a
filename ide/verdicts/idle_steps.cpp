#include "ide/verdicts/idle_steps.h"

#include <algorithm>
#include <utility>

namespace proskill::ide {

namespace {

bool isIdle(const verify::Step& step, const fiacre::Provenance& provenance) {
  return step.changes.empty() && step.failure.empty() &&
         std::ranges::all_of(step.origins, [&](fiacre::OriginId id) {
           return provenance.origins[id].description.empty();
         });
}

/// Numbers of steps before and after some of them are removed.
class Renumbering {
public:
  void add(bool stays) { after.push_back(after.back() + (stays ? 1 : 0)); }
  [[nodiscard]] bool stays(std::size_t step) const { return after[step] != after[step + 1]; }
  /// How many of the first steps stay; also the new number of a step that stays.
  [[nodiscard]] std::size_t of(std::size_t steps) const { return after[steps]; }
  void change(std::vector<verify::Support>& all) const {
    for (auto& support : all) support.since = of(support.since);
  }
  void change(verify::Step& step) const {
    std::erase_if(step.causes, [&](std::size_t cause) { return !stays(cause); });
    for (auto& cause : step.causes) cause = of(cause);
    for (auto& ground : step.grounds) change(ground.support);
    if (step.timer) step.timer->since = of(step.timer->since);
  }

private:
  std::vector<std::size_t> after{0}; ///< by number of steps before
};

} // namespace

verify::Trace withoutIdleSteps(verify::Trace trace, const fiacre::Provenance& provenance) {
  if (provenance.byHand) return trace;
  Renumbering numbers;
  for (const auto& step : trace.steps) numbers.add(!isIdle(step, provenance));
  if (numbers.of(trace.steps.size()) == trace.steps.size()) return trace;
  std::size_t kept = 0; // in place: a long trace takes much memory
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    if (!numbers.stays(i)) continue;
    numbers.change(trace.steps[i]);
    if (kept != i) trace.steps[kept] = std::move(trace.steps[i]);
    ++kept;
  }
  trace.steps.resize(kept);
  numbers.change(trace.support);
  if (trace.loop) trace.loop = numbers.of(*trace.loop);
  return trace;
}

} // namespace proskill::ide
