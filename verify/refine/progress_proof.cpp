#include "verify/refine/progress_proof.h"

#include "verify/reduce/prepared.h"
#include "verify/reduce/recurrent_steps.h"
#include "verify/refine/class_budget.h"

#include <algorithm>

namespace proskill::verify {

ProgressProof::ProgressProof(Slicer& of, const Takes& may, LimitWatch& watch)
    : slicer(of), takes(may), limits(watch), system(of.withLayout()) {
  for (TransitionId id = 0; id < system.transitions.size(); ++id)
    if (system.transitions[id].clock != kNone) excluded.insert(id);
}

bool ProgressProof::run(std::uint64_t together, std::uint64_t each, Exploration& statistics) {
  const bool isSuited = std::ranges::none_of(system.transitions, &Transition::tentative);
  if (!isSuited || system.hasPriorities) return false;
  findRepeating();
  for (bool grew = true; grew;) {
    grew = false;
    const Bits instances = instancesOf(repeating);
    if (instances.empty()) return true;
    instances.each([&](InstanceId instance) {
      if (together == 0 || stepsOf(instance).empty()) return;
      const auto most = std::min(together, each);
      auto left = most;
      grew = settle(instance, left, statistics) || grew;
      spend(most - left, together);
    });
  }
  return false;
}

/// Only steps without a clock repeat without time passing, and of these only some.
void ProgressProof::findRepeating() {
  repeating = {};
  eachIn(recurrentSteps(system, excluded, limits), [&](TransitionId id) { repeating.insert(id); });
}

bool ProgressProof::takesPart(TransitionId step, InstanceId instance) const {
  return std::ranges::any_of(system.transitions[step].parts,
                             [&](PathId part) { return system.paths[part].instance == instance; });
}

Bits ProgressProof::instancesOf(const Bits& steps) const {
  Bits instances;
  steps.each([&](TransitionId step) {
    for (auto part : system.transitions[step].parts) instances.insert(system.paths[part].instance);
  });
  return instances;
}

Bits ProgressProof::stepsOf(InstanceId instance) const {
  Bits steps;
  repeating.each([&](TransitionId step) {
    if (takesPart(step, instance)) steps.insert(step);
  });
  return steps;
}

/// \return whether the steps of the instance do not repeat
bool ProgressProof::settle(InstanceId instance, std::uint64_t& left, Exploration& statistics) {
  Precision precision(slicer);
  auto outcome = Outcome::Refined;
  while (outcome == Outcome::Refined) {
    spend(priceOfSlice(system), left);
    if (left == 0) return false;
    const Slice slice =
        precision.slice({.goals = {}, .steps = stepsOf(instance), .loose = {}, .cells = {}});
    outcome = explore(instance, slice, precision, left, statistics);
  }
  return outcome == Outcome::Shown;
}

ProgressProof::Outcome ProgressProof::explore(InstanceId instance, const Slice& slice,
                                              Precision& precision, std::uint64_t& left,
                                              Exploration& statistics) {
  const auto may = [&](Reduction it) {
    const bool keepsCycles = it == Reduction::LiveVariables || it == Reduction::Inclusion ||
                             it == Reduction::Extrapolation;
    return keepsCycles && takes(it);
  };
  const std::vector<Goal> none;
  const Prepared prepared(precision.systemOf(slice), none, may, limits);
  Explorer explorer(prepared.system, none, prepared.reductions, prepared.extrapolation, limits, {},
                    {.at = {left}, .next = {}});
  const Explored explored = explorer.run();
  addCounts(statistics, explored.statistics);
  spend(explored.statistics.classes, left);
  if (!explored.statistics.complete) return Outcome::GaveUp;
  Bits own;
  for (TransitionId id = 0; id < slice.original.size(); ++id)
    if (repeating.contains(slice.original[id])) own.insert(id);
  const StepCycles cycles(prepared.system, prepared.reductions, explorer.exploredWithNumbers(), own,
                          limits);
  if (!cycles.areAll()) return Outcome::GaveUp;
  if (!cycles.moving().contains(instance)) {
    settleOthers(slice, cycles.moving());
    return Outcome::Shown;
  }
  const auto cycle = cycles.cycleOf(instance);
  Steps steps = explorer.pathTo(explorer.explored().headOf(cycle.start));
  append(steps, cycle.steps); // what the first round changes, the second one may read
  append(steps, cycle.steps);
  return precision.growBy(slice, steps) ? Outcome::Refined : Outcome::GaveUp;
}

/// Excludes the steps of all instances that are on no cycle of the slice, if it has all of their
/// repeating steps.
void ProgressProof::settleOthers(const Slice& slice, const Bits& moving) {
  Bits inSlice;
  for (auto id : slice.original) inSlice.insert(id);
  Bits settled = instancesOf(repeating);
  settled -= moving;
  settled.each([&](InstanceId instance) {
    const Bits steps = stepsOf(instance);
    if (steps.isWithin(inSlice)) excluded |= steps;
  });
  findRepeating();
}

} // namespace proskill::verify
