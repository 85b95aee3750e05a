#include "verify/slice/slice_search.h"

#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/reduce/prepared.h"
#include "verify/reduce/recurrent_steps.h"
#include "verify/slice/whole_run.h"
#include "verify/state/run.h"
#include "verify/state/state_layout.h"
#include "verify/trace/witness.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// A slice that is almost the whole system does not pay off.
bool isSmall(const Bits& cone, const Bits& all) { return cone.count() * 4 <= all.count() * 3; }

/// Whether both can be explored together at little more than the cost of the larger one.
bool isExploredWith(const Bits& cone, const Bits& larger) {
  return cone.isWithin(larger) && (cone.empty() || cone.count() * 2 > larger.count());
}

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

SliceSearch::SliceSearch(const System& system, const System& laidOut,
                         const fiacre::Provenance& origins, Takes may, LimitWatch& watch)
    : whole(laidOut),
      provenance(origins),
      takes(std::move(may)),
      limits(watch),
      slicer(system, watch) {}

Bits SliceSearch::decide(const std::vector<Goal>& goals, const std::vector<std::size_t>& open,
                         Exploration& statistics, const OnDecided& onDecided) {
  Bits decided;
  for (const auto& group : groupsOf(goals, open))
    explore(group, goals, statistics, onDecided, decided);
  return decided;
}

/// Groups goals, the largest cones first: a cone that is not much smaller than one that contains it
/// joins it.
std::vector<SliceSearch::Group> SliceSearch::groupsOf(const std::vector<Goal>& goals,
                                                      const std::vector<std::size_t>& open) {
  std::vector<Group> alone;
  for (auto i : open) {
    if (!Slicer::canDecide(goals[i])) continue;
    Bits cone = slicer.cone({&goals[i]});
    if (isSmall(cone, slicer.moving())) alone.push_back({std::move(cone), {i}});
  }
  std::ranges::stable_sort(alone, std::greater{}, [](const Group& it) { return it.cone.count(); });
  std::vector<Group> groups;
  for (auto& one : alone) {
    const auto larger = std::ranges::find_if(
        groups, [&](const Group& group) { return isExploredWith(one.cone, group.cone); });
    if (larger == groups.end())
      groups.push_back(std::move(one));
    else
      larger->goals.push_back(one.goals.front());
  }
  return groups;
}

void SliceSearch::explore(const Group& group, const std::vector<Goal>& goals,
                          Exploration& statistics, const OnDecided& onDecided, Bits& decided) {
  Slicer::Goals asked;
  std::vector<Goal> own;
  for (auto i : group.goals) {
    asked.push_back(&goals[i]);
    own.push_back(goals[i]);
  }
  const Slice slice = slicer.slice(asked);
  const System allCells = withStateLayout(slice.system);
  const Enabling enabling(allCells);
  const Prepared prepared(slice.system, own, takes, limits);
  const Witness witness(allCells, prepared.reductions, provenance, limits);
  const auto onFound = [&](std::size_t i, const Evidence& evidence) {
    const Evidence tidied = witness.tidied(own[i], evidence);
    const auto dating = dated(allCells, enabling, tidied, limits);
    if (!dating) return;
    const auto steps = wholeRun(whole, slice, tidied.steps, *dating, limits);
    if (!steps) return;
    const Evidence run{*steps, {}};
    if (onDecided(group.goals[i], &run)) decided.insert(static_cast<std::uint32_t>(group.goals[i]));
  };
  const auto found =
      search(prepared.system, own, prepared.reductions, prepared.extrapolation, limits, onFound);
  addCounts(statistics, found.statistics);
  if (found.failure || !found.statistics.complete) return;
  for (std::size_t i = 0; i < own.size(); ++i)
    if (!found.goals[i] && onDecided(group.goals[i], nullptr))
      decided.insert(static_cast<std::uint32_t>(group.goals[i]));
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
  case GoalKind::Unsupported: return false;
  }
  std::unreachable();
}

} // namespace proskill::verify
