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

void intersect(Bits& set, const Bits& other) {
  Bits outside = set;
  outside -= other;
  set -= outside;
}

} // namespace

LiveVariables::LiveVariables(const System& of, const std::vector<Goal>& goals, const Bits& dropped)
    : system(of), keyMask(of.storedWords), keys(of.storedWords) {
  for (const auto& goal : goals) addReads(system, goal.condition, always);
  for (const auto& instance : system.instances) always.insert(instance.location);
  Bits used;
  for (TransitionId i = 0; i < system.transitions.size(); ++i)
    if (!dropped.contains(i))
      for (auto part : system.transitions[i].parts) used.insert(part);
  Bits allCells;
  for (CellId i = 0; i < system.cells.size(); ++i) allCells.insert(i);
  PathsOf paths(system.instances.size());
  for (PathId i = 0; i < system.paths.size(); ++i) {
    written.push_back(surelyWritten(system.paths[i], allCells));
    if (used.contains(i)) paths[system.paths[i].instance].push_back(i);
  }
  Bits tells;
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    tells.insert(system.instances[i].location);
    findNeeded(paths, i);
    findLive(paths[i], places[i]);
    for (const auto& place : places[i])
      for (auto node : place.needed) addReads(system, node, tells);
  }
  tells.each([&](CellId id) {
    const Cell& cell = system.cells[id];
    if (cell.word < system.storedWords) keyMask[cell.word] |= cell.mask;
  });
}

/// The conditions that all paths of a location have in common, of one cell each.
void LiveVariables::findNeeded(const PathsOf& paths, InstanceId instance) {
  auto& all = places.emplace_back(system.instances[instance].locations.size());
  std::vector<std::optional<std::vector<NodeId>>> common(all.size());
  for (auto id : paths[instance]) {
    auto& needed = common[system.paths[id].location];
    auto conjuncts = conjunctsOf(system, system.paths[id].guard);
    if (!needed) needed = conjuncts;
    std::erase_if(*needed, [&](NodeId node) {
      Bits cells;
      addReads(system, node, cells);
      return cells.count() != 1 || std::ranges::find(conjuncts, node) == conjuncts.end();
    });
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (common[i]) all[i].needed = *common[i];
    findRewritten(paths, instance, all[i]);
  }
}

void LiveVariables::findRewritten(const PathsOf& paths, InstanceId instance, Place& place) {
  Bits conditions;
  for (auto node : place.needed) addReads(system, node, conditions);
  for (auto node : place.needed) {
    Bits& cells = place.rewritten.emplace_back();
    for (CellId i = 0; i < system.cells.size(); ++i) cells.insert(i);
    cells -= conditions;
    for (InstanceId other = 0; other < system.instances.size(); ++other)
      for (auto id : paths[other])
        if (other != instance && mayMakeTrue(system, system.paths[id], node))
          for (const auto& [_, sure] : written[id]) intersect(cells, sure);
  }
}

void LiveVariables::findLive(const std::vector<PathId>& own, std::vector<Place>& all) {
  for (bool changed = true; changed;) {
    changed = false;
    for (auto id : own) {
      const Path& path = system.paths[id];
      Bits live = path.guardReads;
      live |= path.reads;
      Bits later = path.writes;
      for (const auto& [target, sure] : written[id]) {
        const Place& next = all[target];
        Bits beyond = next.live;
        beyond -= sure;
        for (std::size_t i = 0; i < next.needed.size(); ++i)
          if (makesFalse(system, path, sure, next.needed[i])) beyond -= next.rewritten[i];
        live |= beyond;
        later |= next.later;
      }
      changed = grow(all[path.location].live, live) || changed;
      changed = grow(all[path.location].later, later) || changed;
    }
  }
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
    const Place& place = places[i][location];
    Bits own = needs[i].empty() ? place.live : needs[i];
    for (std::size_t k = 0; k < place.needed.size() && needs[i].empty(); ++k)
      if (!holds(system, place.needed[k], state)) own -= place.rewritten[k];
    live |= own;
  }
  std::vector<Word> mask(system.storedWords);
  live.each([&](CellId id) {
    const Cell& cell = system.cells[id];
    if (cell.word < system.storedWords) mask[cell.word] |= cell.mask;
  });
  return mask;
}

} // namespace proskill::verify
