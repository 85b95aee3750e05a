#include "verify/sample/goal_index.h"

#include "verify/state/evaluate.h"

#include <algorithm>
#include <tuple>

namespace proskill::verify {

GoalIndex::GoalIndex(const System& of, const std::vector<Goal>& all,
                     const std::vector<std::size_t>& which)
    : system(of),
      goals(all),
      wanted(all.size()),
      byEvent(of.eventCount),
      byCell(of.cells.size()),
      byStep(of.transitions.size()) {
  for (auto i : which)
    if (isFor(goals[i])) add(i);
}

bool GoalIndex::isFor(const Goal& goal) {
  return goal.kind == GoalKind::Events || goal.kind == GoalKind::Condition ||
         goal.kind == GoalKind::Deadlock || goal.kind == GoalKind::Error;
}

void GoalIndex::add(std::size_t goal) {
  const auto& it = goals[goal];
  wanted[goal] = true;
  ++left;
  if (it.kind == GoalKind::Deadlock) return ofEnds.push_back(goal);
  if (it.kind == GoalKind::Error) return ofErrors.push_back(goal);
  Bits events = it.events;
  if (it.kind == GoalKind::Condition) {
    addEvents(system, it.condition, events);
    for (auto cell : readsOf(system, it.condition)) byCell[cell].push_back(goal);
  }
  events.each([&](EventId event) { byEvent[event].push_back(goal); });
}

void GoalIndex::remove(std::size_t goal) {
  if (wanted[goal]) --left;
  wanted[goal] = false;
}

const std::vector<std::size_t>& GoalIndex::reached(TransitionId step, const Word* before,
                                                   const Word* after,
                                                   const std::vector<EventId>& events, bool isEnd) {
  found.clear();
  Bits all;
  for (auto event : events) all.insert(event);
  look(conditionsAfter(step), before, after, all);
  for (auto event : events) look(byEvent[event], before, after, all);
  for (auto goal : ofEnds)
    if (isEnd && wanted[goal] && !holdsAt(system, goals[goal].condition, {after}))
      found.push_back(goal);
  std::ranges::sort(found);
  const auto twice = std::ranges::unique(found);
  found.erase(twice.begin(), twice.end());
  return found;
}

const std::vector<std::size_t>& GoalIndex::conditionsAfter(TransitionId step) {
  auto& known = byStep[step];
  if (known) return *known;
  known.emplace();
  Bits all;
  system.transitions[step].writes.each([&](CellId cell) {
    for (auto goal : byCell[cell]) all.insert(static_cast<std::uint32_t>(goal));
  });
  all.each([&](std::uint32_t goal) { known->push_back(goal); });
  return *known;
}

void GoalIndex::look(std::span<const std::size_t> among, const Word* before, const Word* after,
                     const Bits& events) {
  for (auto goal : among) {
    if (!wanted[goal]) continue;
    const auto& [kind, asked, condition] =
        std::tie(goals[goal].kind, goals[goal].events, goals[goal].condition);
    const bool isReached = kind == GoalKind::Events
                               ? events.meets(asked)
                               : holdsAt(system, condition, {after}) ||
                                     holdsAt(system, condition, {before, after, &events});
    if (isReached) found.push_back(goal);
  }
}

} // namespace proskill::verify
