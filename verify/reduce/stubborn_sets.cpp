#include "verify/reduce/stubborn_sets.h"

#include "verify/model/conjuncts.h"
#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// The participating instances with their source locations.
std::vector<std::pair<InstanceId, std::uint32_t>> placesOf(const System& system,
                                                           const Transition& transition) {
  std::vector<std::pair<InstanceId, std::uint32_t>> all;
  for (auto part : transition.parts)
    all.emplace_back(system.paths[part].instance, system.paths[part].location);
  return all;
}

bool shareInstance(const System& system, const Transition& a, const Transition& b) {
  auto theirs = placesOf(system, b);
  return std::ranges::any_of(placesOf(system, a), [&](const auto& place) {
    return std::ranges::find(theirs, place.first, [](const auto& other) { return other.first; }) !=
           theirs.end();
  });
}

/// Cells that the transition changes, apart from locations.
Bits dataWrites(const System& system, const Transition& transition) {
  Bits cells = transition.writes;
  for (auto part : transition.parts)
    cells.erase(system.instances[system.paths[part].instance].location);
  return cells;
}

} // namespace

/// The transitions that use a cell or a location; all others are independent of it.
struct StubbornSets::Touching {
  using Transitions = std::vector<TransitionId>;

  Touching(const System& system, const Bits& dropped)
      : writers(system.cells.size()),
        readers(system.cells.size()),
        guardedByClock(system.cells.size()) {
    for (const auto& instance : system.instances) at.emplace_back(instance.locations.size());
    for (TransitionId i = 0; i < system.transitions.size(); ++i) {
      const auto& transition = system.transitions[i];
      if (transition.clock != kNone && system.clocks[transition.clock].instance == kNone)
        transition.guardReads.each([&](CellId cell) { guardedByClock[cell].push_back(i); });
      if (dropped.contains(i)) continue;
      Bits read = transition.reads;
      read |= transition.guardReads;
      read.each([&](CellId cell) { readers[cell].push_back(i); });
      transition.writes.each([&](CellId cell) { writers[cell].push_back(i); });
      for (const auto& [instance, location] : placesOf(system, transition))
        at[instance][location].push_back(i);
    }
  }

  std::vector<Transitions> writers;         ///< by cell
  std::vector<Transitions> readers;         ///< by cell: transitions whose guard or code reads it
  std::vector<Transitions> guardedByClock;  ///< by cell: those with a clock of their own whose
                                            ///< guard reads it
  std::vector<std::vector<Transitions>> at; ///< by instance and location
};

StubbornSets::StubbornSets(const System& of, const std::vector<Goal>& goals, const Bits& dropped,
                           LimitWatch& watch)
    : system(of), limits(&watch), none((of.transitions.size() + 63) / 64) {
  const Touching touching(system, dropped);
  findDependence(touching, dropped);
  findNeeds(touching, dropped);
  findWays(dropped);
  findCandidates(touching, goals, dropped);
}

void StubbornSets::findDependence(const Touching& touching, const Bits& dropped) {
  dependent.resize(system.transitions.size());
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    const auto& transition = system.transitions[i];
    if (!transition.urgent || dropped.contains(i)) continue;
    limits->check();
    TransitionSet& found = dependent[i] = none;
    const auto add = [&](const Touching::Transitions& all) {
      for (auto other : all) insert(found, other);
    };
    Bits touched = transition.reads;
    touched |= transition.guardReads;
    touched |= transition.writes;
    touched.each([&](CellId cell) { add(touching.writers[cell]); });
    transition.writes.each([&](CellId cell) { add(touching.readers[cell]); });
    for (const auto& [instance, location] : placesOf(system, transition))
      add(touching.at[instance][location]);
    erase(found, i);
  }
}

/// The transitions that may make a condition true.
const TransitionSet& StubbornSets::helpersOf(const Touching& touching, NodeId node) {
  auto [entry, isNew] = helpers.try_emplace(node, none);
  if (!isNew) return entry->second;
  limits->check();
  Bits cells;
  addReads(system, node, cells);
  cells.each([&](CellId cell) {
    for (auto i : touching.writers[cell])
      if (std::ranges::any_of(system.transitions[i].parts, [&](PathId part) {
            return mayMakeTrue(system, system.paths[part], node);
          }))
        insert(entry->second, i);
  });
  return entry->second;
}

void StubbornSets::findNeeds(const Touching& touching, const Bits& dropped) {
  partners.resize(system.instances.size());
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    limits->check();
    const auto& transition = system.transitions[i];
    auto& made = needs.emplace_back();
    made.locations = placesOf(system, transition);
    for (const auto& [instance, location] : made.locations)
      partners[instance].emplace_back(i, location);
    made.tentative = transition.tentative;
    if (dropped.contains(i)) continue;
    for (auto part : transition.parts)
      for (auto node : conjunctsOf(system, system.paths[part].guard))
        made.conditions.push_back({node, &helpersOf(touching, node)});
    if (!made.tentative) continue;
    made.anyHelper = none;
    transition.guardReads.each([&](CellId cell) {
      for (auto writer : touching.writers[cell]) insert(made.anyHelper, writer);
    });
  }
}

void StubbornSets::findWays(const Bits& dropped) {
  for (const auto& instance : system.instances) {
    others.emplace_back(instance.locations.size());
    moves.emplace_back(instance.locations.size());
    ways.emplace_back(instance.locations.size());
    auto& all = reached.emplace_back(instance.locations.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i].insert(i);
  }
  for (TransitionId i = 0; i < system.transitions.size(); ++i)
    for (auto part : system.transitions[i].parts) {
      const Path& path = system.paths[part];
      for (const auto& instruction : path.code)
        if (instruction.kind == InstructionKind::To && !dropped.contains(i))
          moves[path.instance][path.location].push_back({i, instruction.last});
    }
  for (InstanceId instance = 0; instance < system.instances.size(); ++instance) {
    auto& all = reached[instance];
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t from = all.size(); from-- > 0;) {
        const Bits before = all[from];
        for (const auto& move : moves[instance][from]) all[from] |= Bits(all[move.to]);
        changed = changed || !(all[from] == before);
      }
    }
  }
}

/// The transitions by which an instance may leave its location on the way to the target.
const TransitionSet& StubbornSets::waysTo(InstanceId instance, std::uint32_t from,
                                          std::uint32_t target) const {
  auto& known = ways[instance][from];
  if (known.empty()) known.resize(moves[instance].size());
  TransitionSet& made = known[target];
  if (!made.empty()) return made;
  made = none;
  for (const auto& move : moves[instance][from])
    if (reached[instance][move.to].contains(target)) insert(made, move.transition);
  return made;
}

/// The transitions for which an instance must be in another location.
const TransitionSet& StubbornSets::elsewhere(InstanceId instance, std::uint32_t from) const {
  TransitionSet& made = others[instance][from];
  if (!made.empty()) return made;
  made = none;
  for (const auto& [transition, location] : partners[instance])
    if (location != from) insert(made, transition);
  return made;
}

/// Whether the set holds all that the instance may do next.
bool StubbornSets::isLeftInside(InstanceId instance, std::uint32_t from) const {
  return std::ranges::all_of(moves[instance][from],
                             [&](const Move& move) { return contains(stubborn, move.transition); });
}

/// The transitions that are enabled in every state.
TransitionSet StubbornSets::alwaysPossible() const {
  TransitionSet all = none;
  for (TransitionId i = 0; i < needs.size(); ++i) {
    const auto& needed = needs[i];
    const bool anywhere = std::ranges::all_of(needed.locations, [&](const auto& place) {
      return system.instances[place.first].locations.size() == 1;
    });
    if (anywhere && needed.conditions.empty() && !needed.tentative) insert(all, i);
  }
  return all;
}

/// Finds urgent transitions that no goal observes, that neither start nor stop a clock of another
/// process by their writes, and that depend on no transition that is always possible.
void StubbornSets::findCandidates(const Touching& touching, const std::vector<Goal>& goals,
                                  const Bits& dropped) {
  candidates = none;
  Bits visibleCells;
  Bits visibleEvents;
  for (const auto& goal : goals) {
    if (goal.kind != GoalKind::Condition) continue;
    addReads(system, goal.condition, visibleCells);
    addEvents(system, goal.condition, visibleEvents);
  }
  const TransitionSet possible = alwaysPossible();
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    const auto& transition = system.transitions[i];
    if (!transition.urgent || dropped.contains(i) || transition.writes.meets(visibleCells))
      continue;
    limits->check();
    bool seen = mayPass(system, transition, visibleEvents);
    for (auto part : transition.parts) seen = seen || system.paths[part].mayFail;
    const Bits writes = dataWrites(system, transition);
    writes.each([&](CellId cell) {
      seen = seen || std::ranges::any_of(touching.guardedByClock[cell], [&](TransitionId other) {
               return transition.consumed.empty() ||
                      !shareInstance(system, transition, system.transitions[other]);
             });
    });
    bool disturbed = false;
    for (std::size_t k = 0; k < possible.size(); ++k)
      disturbed = disturbed || (dependent[i][k] & possible[k]) != 0;
    if (!seen && !disturbed) insert(candidates, i);
  }
}

TransitionId StubbornSets::pick(const Word* state, const TransitionSet& enabled) const {
  for (std::size_t k = 0; k < enabled.size(); ++k) {
    for (Word rest = enabled[k] & candidates[k]; rest != 0; rest &= rest - 1) {
      limits->check();
      auto id =
          static_cast<TransitionId>(k * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
      if (isStubbornAlone(id, state, enabled)) return id;
    }
  }
  return kNone;
}

/// Computes the closure of { transition } as a stubborn set; fails if it contains another enabled
/// transition.
bool StubbornSets::isStubbornAlone(TransitionId transition, const Word* state,
                                   const TransitionSet& enabled) const {
  stubborn = dependent[transition];
  for (std::size_t k = 0; k < stubborn.size(); ++k)
    if ((stubborn[k] & enabled[k]) != 0) return false;
  insert(stubborn, transition);
  done = none;
  insert(done, transition);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < stubborn.size(); ++k) {
      for (Word rest = stubborn[k] & ~done[k]; rest != 0; rest = stubborn[k] & ~done[k]) {
        auto id =
            static_cast<TransitionId>(k * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
        insert(done, id);
        const TransitionSet* reason = reasonFor(id, state, enabled);
        if (!reason) return false;
        add(*reason, stubborn);
        changed = true;
      }
    }
  }
  return true;
}

/// Why a transition is disabled: a set of transitions of which one must fire before it can be
/// enabled. None of them may be enabled unless it is in the stubborn set. Chooses the smallest
/// addition.
const TransitionSet* StubbornSets::reasonFor(TransitionId transition, const Word* state,
                                             const TransitionSet& enabled) const {
  const TransitionSet* best = nullptr;
  int least = INT32_MAX;
  const auto consider = [&](const TransitionSet& set) {
    int added = 0;
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Word more = set[k] & ~stubborn[k];
      if ((more & enabled[k]) != 0) return;
      if (more != 0) added += std::popcount(more);
    }
    if (added >= least) return;
    least = added;
    best = &set;
  };
  const Needs& needed = needs[transition];
  for (const auto& [instance, location] : needed.locations) {
    auto now =
        static_cast<std::uint32_t>(readCell(system, system.instances[instance].location, state));
    if (now == location) continue;
    if (isLeftInside(instance, now)) {
      add(elsewhere(instance, now), done);
      return &none;
    }
    consider(waysTo(instance, now, location));
  }
  for (const auto& condition : needed.conditions)
    if (!holds(system, condition.node, state)) consider(*condition.helpers);
  if (needed.tentative) consider(needed.anyHelper);
  return best;
}

} // namespace proskill::verify
