#include "verify/sample/shortened.h"

#include "verify/sample/detours.h"
#include "verify/state/run.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostParts = 16; ///< into which a run is divided, to omit one

class Shortening {
public:
  Shortening(const System& of, const Goal& to, const Evidence& from, const Witness& by,
             std::uint64_t& most)
      : system(of), goal(to), best(from), witness(by), effort(most) {}

  /// \throw LimitMet
  void run() {
    omitDetours();
    for (std::size_t parts = 2; parts <= kMostParts; parts *= 2)
      for (std::size_t i = parts; i-- > 0;) omit(partOf(i, parts));
    omitDetours();
  }
  [[nodiscard]] const Evidence& result() const { return best; }

private:
  /// All detours at once if the rest still has dates, or each for itself.
  void omitDetours() {
    const auto all = detoursOf(system, initialState(system), best.steps, false);
    if (all.empty() || isShorter(all)) return;
    for (std::size_t i = all.size(); i-- > 0;) omit(all[i]);
  }

  void omit(const Detour& steps) {
    if (steps.length() > 0) std::ignore = isShorter({steps});
  }

  [[nodiscard]] Detour partOf(std::size_t i, std::size_t parts) const {
    const std::size_t count = best.steps.size() - 1; // the last one shows the goal
    return {count * i / parts, count * (i + 1) / parts};
  }

  /// Omits these steps if the others still reach the goal. \param some in order
  bool isShorter(const std::vector<Detour>& some) {
    if (effort < best.steps.size()) return false;
    Evidence trial = best;
    trial.steps = without(some, best.steps);
    if (!isPossible(trial.steps)) return false;
    effort -= best.steps.size();
    if (!witness.refutation(goal, trial).empty()) return false;
    best = std::move(trial);
    return true;
  }

  /// Whether the steps can be taken if time is ignored.
  [[nodiscard]] bool isPossible(const Steps& steps) const {
    std::vector<Word> state = initialState(system);
    return std::ranges::all_of(std::span(steps).first(steps.size() - 1), [&](TransitionId step) {
      return isEnabled(system, step, state.data()) &&
             fire(system, step, state.data()) == Outcome::Done;
    });
  }

  const System& system;
  const Goal& goal;
  Evidence best;
  const Witness& witness;
  std::uint64_t& effort;
};

} // namespace

Evidence shortened(const System& system, const Goal& goal, const Evidence& evidence,
                   const Witness& witness, std::uint64_t& effort) {
  if (evidence.steps.size() < 2) return evidence;
  Shortening shortening(system, goal, evidence, witness, effort);
  try {
    shortening.run();
  } catch (const LimitMet&) { // as far as it has come
  }
  return shortening.result();
}

} // namespace proskill::verify
