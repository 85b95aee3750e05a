#include "verify/witness.h"

#include "verify/dates.h"
#include "verify/evaluate.h"
#include "verify/place.h"
#include "verify/replay.h"
#include "verify/watch.h"

#include <algorithm>

namespace proskill::verify {

Witness::Witness(const System& whole, const Bits& leftOut, const fiacre::Provenance& origins)
    : system(whole), dropped(leftOut), provenance(origins) {}

std::expected<Trace, std::string> Witness::trace(const Goal& goal, Evidence evidence) const {
  evidence.steps = completed(goal, evidence.steps);
  auto dating = dated(system, evidence);
  if (!dating) return std::unexpected("the steps have no dates");
  std::string wrong = replay(system, goal, evidence.steps, *dating);
  if (!wrong.empty()) return std::unexpected(wrong);

  Trace made{.scale = dating->scale};
  std::vector<Word> state = initialState(system);
  for (const auto& watched : system.watched)
    made.initial.push_back(
        {watched.display, {}, shown(watched, readCell(system, watched.cell, state.data()))});
  StepLog log;
  for (std::size_t i = 0; i < evidence.steps.size(); ++i) {
    const std::vector<Word> before = state;
    log.clear();
    if (fire(system, evidence.steps[i], state.data(), log) != Outcome::Done)
      return std::unexpected("a step fails");
    const Window& window = dating->steps[i];
    made.steps.push_back({.origins = tellingLast(log),
                          .transitions = {nameOf(evidence.steps[i], log)},
                          .earliest = window.earliest,
                          .latest = window.latest,
                          .date = window.date,
                          .changes = changes(before, state)});
  }
  return made;
}

/// The steps with those of the dropped processes put in where they have to happen: at once.
std::vector<TransitionId> Witness::completed(const Goal& goal,
                                             const std::vector<TransitionId>& steps) const {
  if (dropped.empty()) return steps;
  std::vector<TransitionId> all;
  std::vector<Word> state = initialState(system);
  StepLog log;
  const auto take = [&](TransitionId id) {
    all.push_back(id);
    return fire(system, id, state.data(), log) == Outcome::Done;
  };
  const auto settle = [&](bool alsoLater) {
    for (bool moved = true; moved;) {
      moved = false;
      dropped.each([&](TransitionId id) {
        if (moved || (!system.transitions[id].urgent && !alsoLater)) return;
        moved = isEnabled(system, id, state.data()) && take(id);
      });
    }
  };
  for (auto step : steps) {
    settle(false);
    if (!take(step)) return steps;
  }
  if (goal.kind == GoalKind::Deadlock) settle(true);
  return all;
}

/// As frac names transitions; of a synchronisation the later member comes first.
std::string Witness::nameOf(TransitionId transition, const StepLog& log) const {
  const auto& parts = system.transitions[transition].parts;
  std::string name;
  for (std::size_t i = parts.size(); i-- > 0;) {
    const auto& instance = system.instances[system.paths[parts[i]].instance];
    if (!name.empty()) name += "_";
    name += instance.name + "_t" + std::to_string(log.leaves.at(i));
  }
  return name;
}

/// Each origin once, in the order of the path; those with words after those without.
std::vector<fiacre::OriginId> Witness::tellingLast(const StepLog& log) const {
  std::vector<fiacre::OriginId> all;
  for (auto origin : log.origins)
    if (std::ranges::find(all, origin) == all.end()) all.push_back(origin);
  std::ranges::stable_partition(all, [&](fiacre::OriginId origin) {
    return origin >= provenance.origins.size() || provenance.origins[origin].words.empty();
  });
  return all;
}

std::vector<Change> Witness::changes(const std::vector<Word>& before,
                                     const std::vector<Word>& after) const {
  std::vector<Change> all;
  for (const auto& watched : system.watched) {
    const auto old = readCell(system, watched.cell, before.data());
    const auto now = readCell(system, watched.cell, after.data());
    if (old != now) all.push_back({watched.display, shown(watched, old), shown(watched, now)});
  }
  return all;
}

} // namespace proskill::verify
