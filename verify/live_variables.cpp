#include "verify/live_variables.h"

#include "verify/conjuncts.h"
#include "verify/evaluate.h"
#include "verify/nodes.h"
#include "verify/path_facts.h"

#include <algorithm>

namespace proskill::verify {

namespace {

bool grow(Bits& set, const Bits& more) {
  const Bits before = set;
  set |= more;
  return !(set == before);
}

} // namespace

LiveVariables::LiveVariables(const System& of, const std::vector<Goal>& goals, const Bits& dropped)
    : system(of), keyMask(of.storedWords), keys(of.storedWords) {
  for (const auto& goal : goals) addReads(system, goal.condition, always);
  for (const auto& instance : system.instances) always.insert(instance.location);
  Bits tells;
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    findPlaces(i, dropped);
    tells.insert(system.instances[i].location);
    for (const auto& place : places[i])
      for (auto node : place.needed) addReads(system, node, tells);
  }
  tells.each([&](CellId id) {
    const Cell& cell = system.cells[id];
    if (cell.word < system.storedWords) keyMask[cell.word] |= cell.mask;
  });
}

void LiveVariables::findPlaces(InstanceId instance, const Bits& dropped) {
  auto& all = places.emplace_back(system.instances[instance].locations.size());
  std::vector<PathId> own;
  for (TransitionId i = 0; i < system.transitions.size(); ++i)
    for (auto part : system.transitions[i].parts)
      if (!dropped.contains(i) && system.paths[part].instance == instance &&
          std::ranges::find(own, part) == own.end())
        own.push_back(part);
  Bits allCells;
  for (CellId i = 0; i < system.cells.size(); ++i) allCells.insert(i);
  std::vector<std::map<std::uint32_t, Bits>> written;
  for (auto id : own) written.push_back(surelyWritten(system.paths[id], allCells));
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Path& path = system.paths[own[i]];
      Place& from = all[path.location];
      Bits live = path.guardReads;
      live |= path.reads;
      Bits later = path.writes;
      for (const auto& [target, sure] : written[i]) {
        Bits beyond = all[target].live;
        beyond -= sure;
        live |= beyond;
        later |= all[target].later;
      }
      changed = grow(from.live, live) || changed;
      changed = grow(from.later, later) || changed;
    }
  }
  std::vector<std::optional<std::vector<NodeId>>> common(all.size());
  for (auto id : own) {
    auto& needed = common[system.paths[id].location];
    auto conjuncts = conjunctsOf(system, system.paths[id].guard);
    if (needed)
      std::erase_if(*needed, [&](NodeId node) {
        return std::ranges::find(conjuncts, node) == conjuncts.end();
      });
    else
      needed = conjuncts;
  }
  const auto isOfOneCell = [&](NodeId node) {
    Bits cells;
    addReads(system, node, cells);
    return cells.count() == 1;
  };
  for (std::size_t i = 0; i < all.size(); ++i)
    if (common[i]) std::ranges::copy_if(*common[i], std::back_inserter(all[i].needed), isOfOneCell);
}

void LiveVariables::clean(Word* state) const {
  key.resize(system.storedWords);
  for (std::uint32_t i = 0; i < system.storedWords; ++i) key[i] = state[i] & keyMask[i];
  if (key != lastKey) {
    auto [id, isNew] = keys.add(key.data());
    if (isNew) masks.push_back(maskOf(state));
    last = id;
    lastKey = key;
  }
  for (std::uint32_t i = 0; i < system.storedWords; ++i) state[i] &= masks[last][i];
}

/// For each instance that can never move again, the cells that keep it from moving; empty for the
/// others. Supposes first that all that wait do so for ever, and takes back those whose cell
/// another may still write.
std::vector<Bits> LiveVariables::frozenNeeds(const Word* state) const {
  const auto placeOf = [&](InstanceId i) -> const Place& {
    return places[i]
                 [static_cast<std::size_t>(readCell(system, system.instances[i].location, state))];
  };
  std::vector<std::vector<Bits>> reasons(system.instances.size());
  for (InstanceId i = 0; i < system.instances.size(); ++i)
    for (auto node : placeOf(i).needed)
      if (!holds(system, node, state)) addReads(system, node, reasons[i].emplace_back());
  for (bool changed = true; changed;) {
    Bits written;
    for (InstanceId i = 0; i < system.instances.size(); ++i)
      if (reasons[i].empty()) written |= placeOf(i).later;
    changed = false;
    for (auto& all : reasons)
      changed = std::erase_if(all, [&](const Bits& cells) { return cells.meets(written); }) > 0 ||
                changed;
  }
  std::vector<Bits> needs(system.instances.size());
  for (InstanceId i = 0; i < system.instances.size(); ++i)
    if (!reasons[i].empty()) needs[i] = reasons[i].front();
  return needs;
}

std::vector<Word> LiveVariables::maskOf(const Word* state) const {
  const std::vector<Bits> needs = frozenNeeds(state);
  Bits live = always;
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    auto location = static_cast<std::size_t>(readCell(system, system.instances[i].location, state));
    live |= needs[i].empty() ? places[i][location].live : needs[i];
  }
  std::vector<Word> mask(system.storedWords);
  live.each([&](CellId id) {
    const Cell& cell = system.cells[id];
    if (cell.word < system.storedWords) mask[cell.word] |= cell.mask;
  });
  return mask;
}

} // namespace proskill::verify
