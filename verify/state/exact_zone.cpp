#include "verify/state/exact_zone.h"

#include "verify/state/enabled.h"
#include "verify/state/state_layout.h"

namespace proskill::verify {

std::optional<ExactZone> exactZone(const System& system, const std::vector<TransitionId>& steps,
                                   const Between& between, const Bits& dropped) {
  Timing timing(system, Extrapolation::Least);
  timing.callBetween(between);
  const Enabling enabling(system, dropped);
  StepLog log;
  std::vector<Word> state = initialState(system);
  TransitionSet enabled;
  enabling.compute(state.data(), enabled);
  SignatureId signature = enabling.signature(enabled, timing);
  ZoneId zone = timing.initial(signature);
  for (auto step : steps) {
    if (fire(system, step, state.data(), log) != Outcome::Done) return std::nullopt;
    enabling.update(step, state.data(), enabled);
    const SignatureId next = enabling.signature(enabled, timing);
    zone = timing.after(zone, signature, step, next);
    if (zone == kNone) return std::nullopt;
    signature = next;
  }
  return ExactZone{timing.at(signature).clocks, timing.zones().zone(zone)};
}

} // namespace proskill::verify
