#include "verify/reduce/prepared.h"

#include "verify/model/system_bytes.h"
#include "verify/state/state_layout.h"

namespace proskill::verify {

bool mayTake(Reduction reduction, const Options& options, const System& system) {
  const bool withPriorities =
      reduction == Reduction::Inclusion || reduction == Reduction::Extrapolation;
  return options.reductions.contains(reduction) && (!system.hasPriorities || withPriorities);
}

namespace {

System copyOf(const System& whole, const Bits& cells, LimitWatch& limits) {
  limits.checkLargeGrowth(bytesOf(whole));
  return withStateLayout(whole, cells);
}

} // namespace

Prepared::Prepared(const System& whole, const std::vector<Goal>& goals,
                   const std::function<bool(Reduction)>& takes, LimitWatch& limits)
    : relevance(takes(Reduction::DeadVariables) ? findRelevant(whole, goals, limits)
                                                : everything(whole)),
      system(copyOf(whole, relevance.cells, limits)),
      extrapolation(takes(Reduction::Extrapolation) ? Extrapolation::LowerUpper
                                                    : Extrapolation::Least) {
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
