#include "verify/slice/slice_search.h"

#include "verify/laid_out.h"
#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/reduce/prepared.h"
#include "verify/reduce/recurrent_steps.h"
#include "verify/slice/cone_groups.h"
#include "verify/slice/deadlock_cases.h"
#include "verify/slice/part_text.h"
#include "verify/slice/recurrent_parts.h"
#include "verify/slice/whole_run.h"
#include "verify/state/run.h"
#include "verify/state/state_layout.h"
#include "verify/trace/witness.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <ranges>
#include <set>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostInstances = 4; ///< by which a deadlock is divided into cases
constexpr std::uint64_t kMostClassesOfPart =
    30'000; ///< of a part that is explored for one argument

/// Whether it is possible in every state: its processes have one location each, and it has no other
/// condition.
bool isAlwaysPossible(const System& system, TransitionId id) {
  const Transition& transition = system.transitions[id];
  Bits read;
  addReads(system, transition.guard, read);
  bool isFixed = true;
  read.each(
      [&](CellId cell) { isFixed = isFixed && system.cells[cell].low == system.cells[cell].high; });
  return isFixed && !transition.tentative && !mayBeAnError(system, id) &&
         isEnabled(system, id, initialState(system).data());
}

} // namespace

std::size_t mostInSmallPart(const Bits& all) { return all.count() * 3 / 4; }

bool isSmallPart(const Bits& cone, const Bits& all) { return cone.count() <= mostInSmallPart(all); }

SliceSearch::SliceSearch(const System& system, const System& laidOut,
                         const fiacre::Provenance& origins, Takes may, LimitWatch& watch,
                         AnswerStore* answers)
    : whole(laidOut),
      provenance(origins),
      takes(std::move(may)),
      limits(watch),
      store(answers),
      slicer(system, watch) {}

Bits SliceSearch::decide(const std::vector<Goal>& goals, const std::vector<std::size_t>& open,
                         const SearchSize& most, Exploration& statistics,
                         const OnDecided& onDecided) {
  Bits decided;
  left = most;
  for (const auto& group : groupsOf(goals, open) | std::views::reverse)
    explore(group, goals, statistics, onDecided, decided);
  for (auto i : open)
    if ((goals[i].kind == GoalKind::Deadlock && neverDeadlocks(statistics)) ||
        (goals[i].kind == GoalKind::Stuck && neverStopsTime(statistics)))
      if (onDecided(i, nullptr)) decided.insert(static_cast<std::uint32_t>(i));
  return decided;
}

/// Whether the slice has no run that reaches the goal. Gives up early: the answer is also false if
/// many classes would have to be explored.
bool SliceSearch::isNever(const Slice& slice, const Goal& goal, Exploration& statistics) {
  const auto text = store ? PartText(slice.system).with(goal) : std::string();
  if (store && store->isNeverIn(text)) return true;
  const std::vector<Goal> goals{goal};
  const Prepared prepared(slice.system, goals, takes, limits);
  const auto found = search(prepared.system, goals, prepared.reductions, prepared.extrapolation,
                            limits, [](std::size_t, const Evidence&) {},
                            {.at = {std::min(kMostClassesOfPart, left.classes), left.transitions}});
  count(found, statistics);
  const bool isNever = !found.failure && !found.paused && found.statistics.complete &&
                       found.progressStopped.empty() && !found.goals[0];
  if (isNever && store) store->keepNeverIn(text);
  return isNever;
}

/// Whether the parts show that there is no deadlock.
bool SliceSearch::neverDeadlocks(Exploration& statistics) {
  DeadlockCases cases(slicer);
  std::size_t tried = 0;
  for (auto instance : cases.instances()) {
    if (tried++ == kMostInstances) break;
    const auto all = cases.casesOf(instance);
    if (all && std::ranges::all_of(*all, [&](const PartCase& one) {
          const Slice part = slicer.slice({.goals = {&one.goal}, .steps = {}, .loose = one.loose});
          return isNever(part, one.goal, statistics);
        }))
      return true;
  }
  return false;
}

/// Whether the parts show that time can always go on.
bool SliceSearch::neverStopsTime(Exploration& statistics) {
  const Goal goal{.kind = GoalKind::Stuck};
  const auto parts = recurrentParts(whole, slicer, limits);
  const auto most = mostInSmallPart(slicer.moving());
  return parts && std::ranges::all_of(*parts, [&](const SliceSeeds& seeds) {
           return slicer.coneWithin(seeds, most) && isNever(slicer.slice(seeds), goal, statistics);
         });
}

/// Groups goals, the largest cones first.
std::vector<SliceSearch::Group> SliceSearch::groupsOf(const std::vector<Goal>& goals,
                                                      const std::vector<std::size_t>& open) {
  const auto most = mostInSmallPart(slicer.moving());
  std::vector<ConeGroup> alone;
  for (auto i : grouped(goals, open)) {
    if (!Slicer::canDecide(goals[i])) continue;
    limits.check();
    auto cone = slicer.coneWithin({.goals = {&goals[i]}}, most);
    if (cone) alone.push_back({std::move(*cone), {i}});
  }
  const std::set<std::size_t> asked(open.begin(), open.end());
  std::vector<Group> groups;
  for (auto& one : joined(std::move(alone))) {
    auto& group = groups.emplace_back(std::move(one.goals), std::vector<std::size_t>{});
    std::ranges::copy_if(group.goals, std::back_inserter(group.open),
                         [&](std::size_t i) { return asked.contains(i); });
  }
  std::erase_if(groups, [](const Group& group) { return group.open.empty(); });
  return groups;
}

/// The goals for which slices are made. If answers are kept, these are all goals, so that the
/// slices do not depend on which of them are open.
std::vector<std::size_t> SliceSearch::grouped(const std::vector<Goal>& goals,
                                              const std::vector<std::size_t>& open) const {
  if (!store) return open;
  std::vector<std::size_t> all(goals.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

void SliceSearch::explore(const Group& group, const std::vector<Goal>& goals,
                          Exploration& statistics, const OnDecided& onDecided, Bits& decided) {
  SliceSeeds seeds;
  for (auto i : group.goals) seeds.goals.push_back(&goals[i]);
  const Slice slice = slicer.slice(seeds);
  const auto asked = withoutKnown(group, slice, goals, onDecided, decided);
  if (asked.empty()) return;
  std::vector<Goal> own;
  for (auto i : asked) own.push_back(goals[i]);
  const System allCells = laidOutCopy(slice.system, limits);
  const Prepared prepared(slice.system, own, takes, limits);
  const Witness witness(allCells, prepared.reductions, provenance, limits);
  const Bits planned = slice.punctual();
  const auto onFound = [&](std::size_t i, const Evidence& evidence) {
    const Evidence tidied = witness.tidied(own[i], evidence);
    const auto dating = witness.dates(tidied);
    if (!dating) return;
    const auto all = wholeRun(whole, slice.inWhole(tidied.steps), planned, *dating, 0, limits);
    if (!all.isRun) return;
    const Evidence run{all.steps, {}};
    if (onDecided(asked[i], &run)) decided.insert(static_cast<std::uint32_t>(asked[i]));
  };
  const auto found = search(prepared.system, own, prepared.reductions, prepared.extrapolation,
                            limits, onFound, {.at = left});
  count(found, statistics);
  if (found.failure || !found.statistics.complete) return;
  const std::optional<PartText> text = store ? std::optional<PartText>(slice.system) : std::nullopt;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (found.goals[i]) continue;
    if (text) store->keepNeverIn(text->with(own[i]));
    if (onDecided(asked[i], nullptr)) decided.insert(static_cast<std::uint32_t>(asked[i]));
  }
}

void SliceSearch::count(const SearchResult& found, Exploration& statistics) {
  addCounts(statistics, found.statistics);
  left.classes -= std::min(left.classes, found.statistics.classes);
  left.transitions -= std::min(left.transitions, found.statistics.transitions);
  isCutShort = isCutShort || found.paused;
}

/// The open goals of a group of which it is not known yet that they are never reached in its slice.
std::vector<std::size_t> SliceSearch::withoutKnown(const Group& group, const Slice& slice,
                                                   const std::vector<Goal>& goals,
                                                   const OnDecided& onDecided, Bits& decided) {
  if (!store) return group.open;
  const PartText text(slice.system);
  std::vector<std::size_t> left;
  for (auto i : group.open)
    if (store->isNeverIn(text.with(goals[i])) && onDecided(i, nullptr))
      decided.insert(static_cast<std::uint32_t>(i));
    else
      left.push_back(i);
  return left;
}

bool isPlainlyNever(const System& whole, const Goal& goal, LimitWatch& limits) {
  switch (goal.kind) {
  case GoalKind::Deadlock:
    for (TransitionId i = 0; i < whole.transitions.size(); ++i)
      if (isAlwaysPossible(whole, i)) return true;
    return false;
  case GoalKind::Stuck: return isEmpty(recurrentSteps(whole, {}, limits));
  case GoalKind::Error:
    for (TransitionId i = 0; i < whole.transitions.size(); ++i)
      if (mayBeAnError(whole, i)) return false;
    return true;
  case GoalKind::Events:
  case GoalKind::Condition:
  case GoalKind::Run:
  case GoalKind::Lost:
  case GoalKind::Longest:
  case GoalKind::Shortest:
  case GoalKind::Unsupported: return false;
  }
  std::unreachable();
}

} // namespace proskill::verify
