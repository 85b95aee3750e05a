#include "verify/refine/plan_search.h"

#include "verify/guide/novelty.h"
#include "verify/guide/plan_progress.h"
#include "verify/refine/class_budget.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

namespace {

constexpr std::uint64_t kClassesForOne = 4; ///< neither slices nor distances are computed
constexpr std::uint64_t kLeastClasses = 1'000;
constexpr std::uint64_t kMostClasses = 20'000;
/// Classes for each step of the plan.
constexpr std::uint64_t kLeastPerStep = 8;
constexpr std::uint64_t kMostPerStep = 100;

} // namespace

PlanSearch::PlanSearch(const System& of, const System& laidOut, const fiacre::Provenance& origins,
                       const Takes& may, LimitWatch& watch, const std::vector<Goal>& asked,
                       std::vector<std::size_t> which)
    : system(of),
      whole(laidOut),
      provenance(origins),
      takes(may),
      limits(watch),
      goals(asked),
      open(std::move(which)),
      size(kMostClasses),
      perStep(kMostPerStep) {
  std::erase_if(open, [&](std::size_t i) { return !GoalDistance::isFor(goals[i]); });
}

void PlanSearch::prepare() {
  if (prepared) return;
  std::vector<Goal> all;
  for (auto i : open) all.push_back(goals[i]);
  prepared.emplace(system, all, takes, limits);
  witness.emplace(whole, prepared->reductions, provenance, limits);
}

void PlanSearch::follow(const Steps& plan, std::uint64_t& budget, Bits& decided,
                        Exploration& statistics, const OnDecided& onDecided) {
  prepare();
  std::vector<std::size_t> left;
  std::ranges::copy_if(open, std::back_inserter(left), [&](std::size_t i) {
    return !decided.contains(static_cast<std::uint32_t>(i));
  });
  std::vector<Goal> own;
  for (auto i : left) own.push_back(goals[i]);
  const auto before = decided.count();
  PlanProgress progress(prepared->system, plan);
  Novelty novelty(prepared->system);
  const auto found =
      search(prepared->system, own, prepared->reductions, prepared->extrapolation, limits,
             [&](std::size_t i, const Evidence& evidence) {
               const Evidence run = witness->tidied(own[i], evidence);
               if (onDecided(left[i], &run)) decided.insert(static_cast<std::uint32_t>(left[i]));
             },
             {.at = {std::min(kClassesForOne * budget, size + perStep * plan.size())}, .next = {}},
             {.novelty = &novelty, .plan = &progress});
  addCounts(statistics, found.statistics);
  const bool isUseful = decided.count() > before;
  size = isUseful ? std::min(2 * size, kMostClasses) : std::max(size / 2, kLeastClasses);
  perStep = isUseful ? std::min(2 * perStep, kMostPerStep) : std::max(perStep / 2, kLeastPerStep);
  spend(found.statistics.classes / kClassesForOne, budget);
}

} // namespace proskill::verify
