#include "verify/refine/refinement.h"

#include "verify/refine/class_budget.h"
#include "verify/refine/contraction.h"
#include "verify/slice/part_text.h"
#include "verify/slice/whole_run.h"
#include "verify/state/state_layout.h"
#include "verify/trace/witness.h"

#include <algorithm>
#include <optional>

namespace proskill::verify {

namespace {

/// From this size on, a search is led by the distance to its goal. Smaller ones are not worth the
/// preparation.
constexpr std::uint64_t kMostInOrder = 1'000;

} // namespace

Refinement::Refinement(const System& of, const System& laidOut, const fiacre::Provenance& origins,
                       Takes may, LimitWatch& watch, AnswerStore* answers)
    : split(withSplitTests(of, watch)),
      slicer(split.system, watch),
      system(of),
      whole(laidOut),
      provenance(origins),
      takes(std::move(may)),
      limits(watch),
      store(answers) {}

Bits Refinement::decide(const std::vector<Goal>& goals, const std::vector<std::size_t>& open,
                        Budget budget, Exploration& statistics, const OnDecided& onDecided) {
  Bits decided;
  PlanSearch plans(system, whole, provenance, takes, limits, goals, open);
  for (auto i : open) {
    if (budget.together == 0) break;
    if (!Slicer::canDecide(goals[i]) || decided.contains(static_cast<std::uint32_t>(i))) continue;
    const auto most = std::min(budget.together, budget.each);
    auto left = most;
    const auto before = decided.count();
    const Asked asked{goals[i], [&](const Evidence* run) { return onDecided(i, run); },
                      [&](const Steps& plan, std::uint64_t& classes) {
                        plans.follow(plan, classes, decided, statistics, onDecided);
                        return decided.contains(static_cast<std::uint32_t>(i));
                      }};
    if (decide(asked, left, statistics) == Outcome::Decided)
      decided.insert(static_cast<std::uint32_t>(i));
    spend(most - left, budget.together);
    budget.together += budget.each * (decided.count() - before);
  }
  return decided;
}

Refinement::Outcome Refinement::decide(const Asked& asked, std::uint64_t& left,
                                       Exploration& statistics) {
  Precision precision(slicer);
  auto outcome = Outcome::Refined;
  while (outcome == Outcome::Refined) {
    spend(priceOfSlice(split.system), left);
    if (left == 0) return Outcome::GaveUp;
    const Slice slice =
        precision.slice({.goals = {&asked.goal}, .steps = {}, .loose = {}, .cells = {}});
    outcome = explore(asked, slice, precision, left, statistics);
  }
  return outcome;
}

Refinement::Outcome Refinement::explore(const Asked& asked, const Slice& slice,
                                        Precision& precision, std::uint64_t& left,
                                        Exploration& statistics) {
  const auto& goal = asked.goal;
  const auto [part, before, original] = contracted(precision.systemOf(slice), goal, limits);
  const auto text = store ? PartText(part).with(goal) : std::string();
  if (store && store->isNeverIn(text)) return never(asked);
  const Prepared prepared(part, {goal}, takes, limits);
  const auto found = searchFor(goal, part, prepared, left, statistics);
  if (found.failure) return Outcome::GaveUp;
  if (!found.goals[0]) {
    if (!found.statistics.complete) return Outcome::GaveUp;
    if (store) store->keepNeverIn(text);
    return never(asked);
  }
  const System allCells = withStateLayout(part);
  const Witness witness(allCells, prepared.reductions, provenance, limits);
  Steps steps = before;
  for (auto step : witness.tidied(goal, *found.goals[0]).steps)
    std::ranges::copy(original[step], std::back_inserter(steps));
  const auto run = completed(slice, steps);
  if (run) {
    const Evidence evidence{*run, {}};
    if (asked.onDecided(&evidence)) return Outcome::Decided;
  }
  if (precision.hasTime() && asked.follow(inSystem(slice, steps), left)) return Outcome::Decided;
  return precision.growBy(slice, steps) ? Outcome::Refined : Outcome::GaveUp;
}

Refinement::Outcome Refinement::never(const Asked& asked) {
  return asked.onDecided(nullptr) ? Outcome::Decided : Outcome::GaveUp;
}

/// Searches breadth-first, and if that takes long, once more with the states next to the goal
/// first.
SearchResult Refinement::searchFor(const Goal& goal, const System& part, const Prepared& prepared,
                                   std::uint64_t& left, Exploration& statistics) {
  const auto most = std::min(kMostInOrder, left);
  auto found = searchFor(goal, prepared, nullptr, most, left, statistics);
  if (!found.paused || left == 0) return found;
  std::optional<GoalDistance> distance;
  if (GoalDistance::isFor(goal))
    distance.emplace(part, prepared.system, goal, prepared.reductions.dropped, limits);
  return searchFor(goal, prepared, distance ? &*distance : nullptr, left, left, statistics);
}

SearchResult Refinement::searchFor(const Goal& goal, const Prepared& prepared,
                                   GoalDistance* distance, std::uint64_t most, std::uint64_t& left,
                                   Exploration& statistics) {
  auto found = search(prepared.system, {goal}, prepared.reductions, prepared.extrapolation, limits,
                      [](std::size_t, const Evidence&) {}, {.at = {most}, .next = {}}, {distance});
  addCounts(statistics, found.statistics);
  spend(found.statistics.classes, left);
  return found;
}

/// Steps of the slice as steps of the system, without those that others take meanwhile.
Steps Refinement::inSystem(const Slice& slice, const Steps& steps) const {
  Steps made = slice.inWhole(steps);
  for (auto& step : made) step = split.original[step];
  return made;
}

/// Completes steps of the slice to a run of the whole.
std::optional<Steps> Refinement::completed(const Slice& slice, const Steps& steps) {
  const System allCells = withStateLayout(slice.system);
  const auto dating = dated(allCells, Enabling(allCells), {steps, {}}, limits);
  if (!dating) return std::nullopt;
  Bits planned;
  slice.punctual().each([&](TransitionId id) { planned.insert(split.original[id]); });
  return wholeRun(whole, inSystem(slice, steps), planned, *dating, limits);
}

bool Refinement::showProgress(Budget budget, Exploration& statistics) {
  return ProgressProof(slicer, takes, limits).run(budget.together, budget.each, statistics);
}

} // namespace proskill::verify
