#include "verify/refine/refinement.h"

#include "verify/laid_out.h"
#include "verify/refine/class_budget.h"
#include "verify/slice/cone_groups.h"
#include "verify/trace/witness.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <ranges>
#include <utility>

namespace proskill::verify {

namespace {

/// From this size on, a search is led by the distance to its goal. Smaller ones are not worth the
/// preparation.
constexpr std::uint64_t kMostInOrder = 1'000;

/// The questions of a slice of so few classes stay together when they are refined: it is cheaper to
/// know too much than to make another slice.
constexpr std::uint64_t kMostTogether = 100;

/// The part of what is left for a question that a search of hulls may take.
constexpr std::uint64_t kShareOfHulls = 4;

/// So many steps of a run take as long as a class.
constexpr std::uint64_t kStepsForOne = 4;

bool isDecided(const Bits& decided, std::size_t goal) {
  return decided.contains(static_cast<std::uint32_t>(goal));
}

/// Adds a question to a group, or as a new one.
/// \param isJoined whether groups may know more than the question needs
template <class Group>
void addTo(std::vector<Group>& groups, const Precision& precision, std::size_t goal,
           bool isJoined) {
  const auto suits = [&](const Group& group) {
    return group.precision == precision ||
           (isJoined && group.precision.hasTime() == precision.hasTime());
  };
  const auto found = std::ranges::find_if(groups, suits);
  if (found == groups.end()) {
    groups.push_back({precision, {goal}});
    return;
  }
  found->precision.join(precision);
  found->goals.push_back(goal);
}

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
  PlanSearch plans(system, whole, provenance, takes, limits, goals, open);
  Asking asking{.goals = goals,
                .plans = plans,
                .statistics = statistics,
                .onDecided = onDecided,
                .each = budget.each,
                .together = budget.together,
                .left = std::vector<std::uint64_t>(goals.size(), budget.each),
                .leftForPlans = std::vector<std::uint64_t>(goals.size(), budget.each)};
  for (addGroups(open, asking); !asking.groups.empty() && asking.together > 0;) {
    Group group = std::move(asking.groups.front());
    asking.groups.pop_front();
    std::erase_if(group.goals, [&](std::size_t i) { return isDecided(asking.decided, i); });
    if (group.goals.empty()) continue;
    const auto before = asking.decided.count();
    explore(group, asking);
    asking.together += budget.each * (asking.decided.count() - before);
  }
  return std::move(asking.decided);
}

/// Groups questions whose first slices are about nearly the same part. Each call begins anew, so
/// that a verification that was interrupted goes on as if it had not been.
void Refinement::addGroups(const std::vector<std::size_t>& open, Asking& asking) {
  std::vector<ConeGroup> alone;
  for (auto i : open) {
    if (!Slicer::canDecide(asking.goals[i])) continue;
    const auto [cone, isNew] = cones.try_emplace(i);
    if (isNew) cone->second = slicer.cone({.goals = {&asking.goals[i]}, .cells = Bits{}});
    alone.push_back({cone->second, {i}});
  }
  for (auto& group : joined(std::move(alone)) | std::views::reverse)
    asking.groups.push_back({Precision(slicer), std::move(group.goals)});
}

/// Explores a slice for the group, and adds the groups of its questions that are still open.
void Refinement::explore(const Group& all, Asking& asking) {
  Group group = all;
  pay(priceOfSlice(split.system), group, asking);
  std::erase_if(group.goals, [&](std::size_t i) {
    const bool isSpent = asking.left[i] == 0;
    if (isSpent) giveUp(i, group, asking);
    return isSpent;
  });
  if (group.goals.empty() || asking.together == 0) return;
  RefinedSlice slice(group.precision, goalsOf(group, asking), limits);
  std::optional<PartText> text; // it names the part in the store
  if (store) text.emplace(slice.part());
  if (text) dropKnown(*text, group, asking);
  if (group.goals.empty()) return;
  const Prepared prepared(slice.part(), goalsOf(group, asking), takes, limits);
  const auto found = searchFor(group, slice.part(), prepared, asking);
  if (found.failure) return;
  readRuns(group, slice, prepared, found, asking);
  const bool isAlone = group.goals.size() == 1;
  for (std::size_t i = 0; i < group.goals.size(); ++i) {
    const auto goal = group.goals[i];
    if (found.goals[i]) continue;
    if (!found.statistics.complete) {
      if (isAlone)
        giveUp(goal, group, asking);
      else
        asking.groups.push_back({group.precision, {goal}, group.isWide});
      continue;
    }
    if (text) store->keepNeverIn(text->with(asking.goals[goal]));
    note(goal, nullptr, asking);
    if (group.precision.isRefined()) ++asking.gainOf(group).decided;
  }
}

/// Decides the questions of which it is known that they are never reached in the part.
void Refinement::dropKnown(const PartText& text, Group& group, Asking& asking) {
  std::erase_if(group.goals, [&](std::size_t i) {
    if (!store->isNeverIn(text.with(asking.goals[i]))) return false;
    note(i, nullptr, asking);
    return true;
  });
}

/// Searches breadth-first. If that takes long, a single question is searched for once more, with
/// the states next to the goal first.
SearchResult Refinement::searchFor(const Group& group, const System& part, const Prepared& prepared,
                                   Asking& asking) {
  const auto inOrder = std::min(kMostInOrder * group.goals.size(), mostFor(group, asking));
  auto found = searchFor(group, prepared, prepared.reductions, nullptr, inOrder, asking);
  if (!found.paused || mostFor(group, asking) == 0 || group.goals.size() > 1) return found;
  if (group.precision.hasTime())
    if (auto hulls = searchHulls(group, prepared, asking)) return *hulls;
  const auto most = mostFor(group, asking);
  if (most == 0) return found;
  const Goal& goal = asking.goals[group.goals.front()];
  std::optional<GoalDistance> distance;
  if (GoalDistance::isFor(goal))
    distance.emplace(part, prepared.system, goal, prepared.reductions.dropped, limits);
  return searchFor(group, prepared, prepared.reductions, distance ? &*distance : nullptr, most,
                   asking);
}

/// Searches with one zone for each state. Where dates differ by what happened before, there are
/// very many zones, and what never happens is mostly shown by their hulls.
/// \return nothing if this does not show that the goal is never reached
std::optional<SearchResult> Refinement::searchHulls(const Group& group, const Prepared& prepared,
                                                    Asking& asking) {
  if (!prepared.reductions.inclusion) return std::nullopt;
  Reductions reductions = prepared.reductions;
  reductions.hull = true;
  auto found = searchFor(group, prepared, reductions, nullptr,
                         mostFor(group, asking) / kShareOfHulls, asking);
  const bool isNever = !found.failure && found.statistics.complete && !found.goals[0];
  return isNever ? std::optional(std::move(found)) : std::nullopt;
}

SearchResult Refinement::searchFor(const Group& group, const Prepared& prepared,
                                   const Reductions& reductions, GoalDistance* distance,
                                   std::uint64_t most, Asking& asking) {
  auto found =
      search(prepared.system, goalsOf(group, asking), reductions, prepared.extrapolation, limits,
             [](std::size_t, const Evidence&) {}, {.at = {most}, .next = {}}, {distance});
  addCounts(asking.statistics, found.statistics);
  pay(found.statistics.classes, group, asking);
  return found;
}

/// Completes the runs that were found to runs of the whole, or else refines the slices.
void Refinement::readRuns(const Group& group, RefinedSlice& slice, const Prepared& prepared,
                          const SearchResult& found, Asking& asking) {
  if (std::ranges::none_of(found.goals, &std::optional<Evidence>::has_value)) return;
  const System allCells = laidOutCopy(slice.part(), limits);
  const Witness witness(allCells, prepared.reductions, provenance, limits);
  const bool isSmall = found.statistics.classes <= kMostTogether;
  const bool isWide = group.isWide || asking.wide.decided > asking.narrow.decided;
  std::vector<Group> refined;
  for (std::size_t i = 0; i < group.goals.size(); ++i) {
    const auto goal = group.goals[i];
    if (!found.goals[i] || isDecided(asking.decided, goal)) continue;
    const Steps steps = slice.inSlice(witness.tidied(asking.goals[goal], *found.goals[i]).steps);
    if (isDecidedBy(steps, goal, group, slice, asking)) continue;
    Precision precision = group.precision;
    if (!precision.growBy(slice.uncontracted(), steps)) {
      giveUp(goal, group, asking);
      continue;
    }
    addTo(refined, isWide ? precision.widened(alikeCells()) : precision, goal, isSmall);
  }
  if (isWide)
    std::ranges::for_each(refined, [&](const Group& next) { addWide(next, asking); });
  else
    asking.groups.insert(asking.groups.begin(), std::make_move_iterator(refined.begin()),
                         std::make_move_iterator(refined.end()));
}

/// Wide slices that know nearly the same are mostly the same, whatever the question.
void Refinement::addWide(const Group& refined, Asking& asking) {
  const auto suits = [&](const Group& group) {
    return group.isWide && group.precision.isLike(refined.precision);
  };
  const auto found = std::ranges::find_if(asking.groups, suits);
  if (found == asking.groups.end())
    return asking.groups.push_back({refined.precision, refined.goals, true});
  found->precision.join(refined.precision);
  found->goals.insert(found->goals.end(), refined.goals.begin(), refined.goals.end());
}

/// Tries a wide slice where a narrow one was not enough, until that has failed too often.
void Refinement::giveUp(std::size_t goal, const Group& group, Asking& asking) {
  ++asking.gainOf(group).failed;
  if (group.isWide || !group.precision.isRefined() || asking.wide.fails()) return;
  Group wide{group.precision.widened(alikeCells()), {goal}, true};
  if (wide.precision == group.precision) return;
  asking.left[goal] = asking.each;
  asking.groups.push_front(std::move(wide));
}

const AlikeCells& Refinement::alikeCells() {
  if (!alike) alike.emplace(slicer);
  return *alike;
}

/// Whether a run of the slice, or a search along it, decides the question.
bool Refinement::isDecidedBy(const Steps& steps, std::size_t goal, const Group& group,
                             RefinedSlice& slice, Asking& asking) {
  const bool isPlan = group.precision.hasTime();
  const WholeRun along =
      inWhole(slice, steps, isPlan ? kStepsForOne * asking.leftForPlans[goal] : 0);
  if (along.isRun) {
    const Evidence evidence{along.steps, {}};
    note(goal, &evidence, asking);
  } else {
    payForPlan((along.steps.size() - steps.size()) / kStepsForOne, goal, asking);
  }
  if (isPlan && !isDecided(asking.decided, goal)) follow(along.steps, goal, asking);
  return isDecided(asking.decided, goal);
}

/// Searches the whole along a run of a slice.
void Refinement::follow(const Steps& plan, std::size_t goal, Asking& asking) {
  const auto most = std::min(asking.leftForPlans[goal], asking.together);
  auto left = most;
  asking.plans.follow(plan, left, asking.decided, asking.statistics, asking.onDecided);
  payForPlan(most - left, goal, asking);
}

/// \param run of the whole that reaches the goal; null: it is never reached
void Refinement::note(std::size_t goal, const Evidence* run, Asking& asking) {
  if (asking.onDecided(goal, run)) asking.decided.insert(static_cast<std::uint32_t>(goal));
}

/// How many classes a search for the group may find.
std::uint64_t Refinement::mostFor(const Group& group, const Asking& asking) {
  std::uint64_t sum = 0;
  std::uint64_t most = 0;
  for (auto i : group.goals) {
    sum += asking.left[i];
    most = std::max(most, asking.left[i]);
  }
  return std::min({sum, asking.together, std::max(most, asking.together / 4)});
}

void Refinement::payForPlan(std::uint64_t classes, std::size_t goal, Asking& asking) {
  spend(classes, asking.leftForPlans[goal]);
  spend(classes, asking.together);
}

/// Each question of the group pays the same.
void Refinement::pay(std::uint64_t classes, const Group& group, Asking& asking) {
  const auto count = group.goals.size();
  for (auto i : group.goals) spend((classes + count - 1) / count, asking.left[i]);
  spend(classes, asking.together);
}

std::vector<Goal> Refinement::goalsOf(const Group& group, const Asking& asking) {
  std::vector<Goal> goals;
  for (auto i : group.goals) goals.push_back(asking.goals[i]);
  return goals;
}

/// Steps of the slice as steps of the system, without those that others take meanwhile.
Steps Refinement::inSystem(const Slice& slice, const Steps& steps) const {
  Steps made = slice.inWhole(steps);
  for (auto& step : made) step = split.original[step];
  return made;
}

/// What the whole does along steps of the slice; without dates only these.
WholeRun Refinement::inWhole(RefinedSlice& of, const Steps& steps, std::size_t mostOfPlan) const {
  const Slice& slice = of.uncontracted();
  const auto dating = of.datingOf(steps);
  if (!dating) return {inSystem(slice, steps)};
  Bits planned;
  slice.punctual().each([&](TransitionId id) { planned.insert(split.original[id]); });
  return wholeRun(whole, inSystem(slice, steps), planned, *dating, mostOfPlan, limits);
}

bool Refinement::showNoRun(const Goal& goal, std::uint64_t most, Exploration& statistics) {
  return RunProof(slicer, provenance, takes, limits, store).run(goal, most, statistics);
}

bool Refinement::showProgress(Budget budget, Exploration& statistics) {
  return ProgressProof(slicer, takes, limits).run(budget.together, budget.each, statistics);
}

} // namespace proskill::verify
