#include "verify/state/enabled.h"

#include "verify/state/evaluate.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace proskill::verify {

namespace {

/// With fewer transitions from a location it is faster to evaluate each of them.
constexpr std::size_t kMany = 64;
constexpr std::size_t kMostCrowdWords = 1'000'000; ///< of all sets of transitions by location

/// \param most transitions that one location has
/// \param words of all sets
bool hasNoCrowds(std::size_t most, std::size_t words) {
  return most < kMany || words > kMostCrowdWords;
}

TransitionSet allBut(const Bits& dropped, std::size_t transitions) {
  TransitionSet all((transitions + 63) / 64);
  for (TransitionId i = 0; i < transitions; ++i)
    if (!dropped.contains(i)) insert(all, i);
  return all;
}

} // namespace

Enabling::Enabling(const System& of, const Bits& dropped)
    : system(of), tables(of, allBut(dropped, of.transitions.size())) {
  urgent = clocked = TransitionSet((system.transitions.size() + 63) / 64);
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    if (dropped.contains(i)) continue;
    if (system.transitions[i].urgent) insert(urgent, i);
    if (system.transitions[i].clock != kNone) insert(clocked, i);
  }
  findGuards();
  findPlaces(dropped);
  findAffected(dropped);
  findCrowds();
}

void Enabling::findGuards() {
  for (const auto& transition : system.transitions) {
    Guard& guard = guards.emplace_back();
    guard.first = static_cast<std::uint32_t>(tests.size());
    tests.insert(tests.end(), transition.tests.begin(), transition.tests.end());
    guard.last = static_cast<std::uint32_t>(tests.size());
    guard.isWhole = transition.rest.empty() && !transition.tentative;
  }
}

std::uint64_t Enabling::mostBytes(const System& system) {
  std::size_t locations = 0;
  std::vector<std::vector<std::size_t>> count; // of transitions, by instance and location
  for (const auto& instance : system.instances) {
    locations += instance.locations.size();
    count.emplace_back(instance.locations.size());
  }
  std::size_t most = 0;
  for (const auto& transition : system.transitions)
    for (auto part : transition.parts) {
      const Path& path = system.paths[part];
      most = std::max(most, ++count[path.instance][path.location]);
    }
  const std::size_t words = locations * ((system.transitions.size() + 63) / 64);
  return hasNoCrowds(most, words) ? 0 : 2 * words * sizeof(Word); // of `crowds` and `possible`
}

void Enabling::findCrowds() {
  std::size_t most = 0;
  std::size_t locations = 0;
  for (const auto& all : takingPart) {
    locations += all.size();
    for (const auto& here : all) most = std::max(most, here.size());
  }
  if (hasNoCrowds(most, locations * urgent.size())) return;
  for (const auto& all : takingPart) {
    auto& crowd = crowds.emplace_back(all.size(), TransitionSet(urgent.size()));
    TransitionSet others(urgent.size(), ~Word{0}); // those in which the instance takes no part
    for (std::size_t i = 0; i < all.size(); ++i)
      for (auto transition : all[i]) {
        insert(crowd[i], transition);
        erase(others, transition);
      }
    auto& here = possible.emplace_back(all.size(), others);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < others.size(); ++k) here[i][k] |= crowd[i][k];
  }
}

void Enabling::findPlaces(const Bits& dropped) {
  for (const auto& instance : system.instances) takingPart.emplace_back(instance.locations.size());
  starting = takingPart;
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    if (dropped.contains(i)) continue;
    const auto& parts = system.transitions[i].parts;
    const Path& first = system.paths[parts.front()];
    starting[first.instance][first.location].push_back(i);
    for (auto part : parts)
      takingPart[system.paths[part].instance][system.paths[part].location].push_back(i);
  }
}

void Enabling::findAffected(const Bits& dropped) {
  std::vector<std::vector<TransitionId>> readers(system.cells.size());
  for (TransitionId i = 0; i < system.transitions.size(); ++i) {
    if (dropped.contains(i)) continue;
    Bits others = system.transitions[i].guardReads;
    for (auto part : system.transitions[i].parts)
      others.erase(system.instances[system.paths[part].instance].location);
    others.each([&](CellId cell) { readers[cell].push_back(i); });
  }
  TransitionSet all(urgent.size());
  std::vector<std::uint32_t> words;
  for (const auto& transition : system.transitions) {
    affectedBy.push_back(static_cast<std::uint32_t>(affected.size()));
    words.clear();
    transition.writes.each([&](CellId cell) {
      for (auto reader : readers[cell]) {
        if (all[reader / 64] == 0) words.push_back(reader / 64);
        insert(all, reader);
      }
    });
    for (auto word : words) affected.push_back({word, std::exchange(all[word], 0)});
  }
  affectedBy.push_back(static_cast<std::uint32_t>(affected.size()));
}

bool Enabling::isPossible(TransitionId transition, const Word* state) const {
  const Guard& guard = guards[transition];
  for (auto i = guard.first; i < guard.last; ++i)
    if (((state[tests[i].word] & tests[i].mask) == tests[i].value) != tests[i].equal) return false;
  return guard.isWhole || isEnabled(system, transition, state);
}

void Enabling::look(TransitionId transition, const Word* state, TransitionSet& enabled) const {
  if (isPossible(transition, state))
    insert(enabled, transition);
  else
    erase(enabled, transition);
}

void Enabling::compute(const Word* state, TransitionSet& enabled) const {
  if (tables.pay()) return computeByTables(state, enabled);
  enabled.assign(urgent.size(), 0);
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    const std::size_t location = locationOf(i, state);
    if (isCrowded(i, location)) {
      lookAtPlace(i, state, enabled);
      continue;
    }
    for (auto transition : starting[i][location])
      if (isPossible(transition, state)) insert(enabled, transition);
  }
}

void Enabling::computeByTables(const Word* state, TransitionSet& enabled) const {
  tables.findCandidates(state, enabled);
  eachInBoth(enabled, tables.undecided(), [&](TransitionId transition) {
    if (!isPossible(transition, state)) erase(enabled, transition);
  });
}

bool Enabling::isCrowded(InstanceId instance, std::size_t location) const {
  return !crowds.empty() && takingPart[instance][location].size() >= kMany;
}

/// Evaluates the transitions in which an instance takes part from where it is.
void Enabling::lookAtPlace(InstanceId instance, const Word* state, TransitionSet& enabled) const {
  const std::size_t location = locationOf(instance, state);
  if (!isCrowded(instance, location)) {
    for (auto transition : takingPart[instance][location]) look(transition, state, enabled);
    return;
  }
  const TransitionSet& crowd = crowds[instance][location];
  for (std::size_t k = 0; k < crowd.size(); ++k) {
    if (crowd[k] == 0) continue;
    enabled[k] &= ~crowd[k];
    Word rest = crowd[k];
    for (InstanceId i = 0; i < system.instances.size() && rest != 0; ++i)
      rest &= possible[i][locationOf(i, state)][k];
    for (; rest != 0; rest &= rest - 1) {
      const auto transition = static_cast<TransitionId>(k * 64 + std::countr_zero(rest));
      if (isPossible(transition, state)) insert(enabled, transition);
    }
  }
}

void Enabling::refresh(const TransitionSet& changed, const Word* state,
                       TransitionSet& enabled) const {
  eachIn(changed, [&](TransitionId transition) { look(transition, state, enabled); });
}

void Enabling::update(TransitionId fired, const Word* state, TransitionSet& enabled) const {
  for (auto part : system.transitions[fired].parts) {
    const Path& path = system.paths[part];
    if (!isCrowded(path.instance, path.location))
      for (auto transition : takingPart[path.instance][path.location]) erase(enabled, transition);
    else
      for (std::size_t k = 0; k < enabled.size(); ++k)
        enabled[k] &= ~crowds[path.instance][path.location][k];
  }
  for (auto part : system.transitions[fired].parts)
    lookAtPlace(system.paths[part].instance, state, enabled);
  for (auto i = affectedBy[fired]; i < affectedBy[fired + 1]; ++i)
    for (Word rest = affected[i].bits; rest != 0; rest &= rest - 1)
      look(affected[i].word * 64 + static_cast<TransitionId>(std::countr_zero(rest)), state,
           enabled);
}

std::size_t Enabling::locationOf(InstanceId instance, const Word* state) const {
  return static_cast<std::size_t>(readCell(system, system.instances[instance].location, state));
}

bool Enabling::isUrgent(const TransitionSet& enabled) const {
  for (std::size_t k = 0; k < enabled.size(); ++k)
    if ((enabled[k] & urgent[k]) != 0) return true;
  return false;
}

SignatureId Enabling::signature(const TransitionSet& enabled, bool isUrgent, Timing& timing) const {
  return timing.signature(isUrgent, enabled, clocked);
}

} // namespace proskill::verify
