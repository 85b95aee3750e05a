#include "verify/reduce/prepared.h"

#include "verify/laid_out.h"
#include "verify/reduce/idle_tests.h"
#include "verify/state/state_layout.h"

namespace proskill::verify {

bool mayTake(Reduction reduction, const Options& options, const System& system) {
  const bool withPriorities =
      reduction == Reduction::Inclusion || reduction == Reduction::Extrapolation;
  return options.reductions.contains(reduction) && (!system.hasPriorities || withPriorities);
}

namespace {

/// A copy, without the tests that decide about nothing but events that nobody asks for.
System copyOf(const System& whole, const std::vector<Goal>& goals, bool mayOmit,
              LimitWatch& limits) {
  System copy = checkedCopy(whole, limits);
  return mayOmit ? withoutIdleTests(std::move(copy), eventsOf(whole, goals)) : copy;
}

} // namespace

Prepared::Prepared(const System& whole, const std::vector<Goal>& goals,
                   const std::function<bool(Reduction)>& takes, LimitWatch& limits)
    : system(copyOf(whole, goals, takes(Reduction::DeadVariables), limits)),
      relevance(takes(Reduction::DeadVariables) ? findRelevant(system, goals, limits)
                                                : everything(system)),
      extrapolation(takes(Reduction::Extrapolation) ? Extrapolation::LowerUpper
                                                    : Extrapolation::Least) {
  system = withStateLayout(std::move(system), relevance.cells);
  const Bits& dropped = reductions.dropped = relevance.dropped;
  reductions.inclusion = takes(Reduction::Inclusion);
  if (takes(Reduction::StubbornSets))
    reductions.stubbornSets = &stubbornSets.emplace(system, goals, dropped, limits);
  if (takes(Reduction::LiveVariables))
    reductions.liveVariables = &liveVariables.emplace(system, goals, dropped, limits);
  if (takes(Reduction::FreeInputs) && !freeInputs.emplace(system, goals, dropped).none())
    reductions.freeInputs = &*freeInputs;
  if (takes(Reduction::PrivateMoves) && reductions.freeInputs &&
      !privateMoves.emplace(system, goals, dropped, *freeInputs).none())
    reductions.privateMoves = &*privateMoves;
}

} // namespace proskill::verify
