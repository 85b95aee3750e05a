#include "verify/reduce/live_variables.h"

#include "verify/model/conjuncts.h"
#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <span>

namespace proskill::verify {

namespace {

bool grow(Bits& set, const Bits& more) {
  const Bits before = set;
  set |= more;
  return !(set == before);
}

} // namespace

LiveVariables::LiveVariables(const System& of, const std::vector<Goal>& goals, const Bits& dropped,
                             LimitWatch& watch)
    : system(of), limits(&watch), keyMask(of.storedWords), keys(of.storedWords) {
  for (const auto& goal : goals) addReads(system, goal.condition, always);
  for (const auto& instance : system.instances) always.insert(instance.location);
  Bits used;
  for (TransitionId i = 0; i < system.transitions.size(); ++i)
    if (!dropped.contains(i))
      for (auto part : system.transitions[i].parts) used.insert(part);
  for (CellId i = 0; i < system.cells.size(); ++i) allCells.insert(i);
  PathsOf paths(system.instances.size());
  writing.resize(system.cells.size());
  for (PathId i = 0; i < system.paths.size(); ++i) {
    limits->check();
    written.push_back(surelyWritten(system.paths[i]));
    if (!used.contains(i)) continue;
    paths[system.paths[i].instance].push_back(i);
    system.paths[i].writes.each([&](CellId cell) { writing[cell].push_back(i); });
  }
  Bits tells;
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    tells.insert(system.instances[i].location);
    findNeeded(paths, i);
    findWays(paths, i);
    findLive(places[i]);
    for (const auto& place : places[i]) {
      for (auto node : place.needed) addReads(system, node, tells);
      for (const auto& way : place.ways)
        for (const auto& need : way.needs) addReads(system, need.condition, tells);
    }
  }
  keyMask = maskOf(tells);
  allMask = maskOf(allCells);
  alwaysMask = maskOf(always);
  limits->checkLargeGrowth(maskBytes());
  for (auto& ofInstance : places)
    for (auto& place : ofInstance) findMasks(place);
}

/// The bytes of the masks of all places.
std::uint64_t LiveVariables::maskBytes() const {
  std::uint64_t masks = 0;
  for (const auto& ofInstance : places)
    for (const auto& place : ofInstance) {
      masks += 2 + place.needed.size();
      for (const auto& way : place.ways) masks += 1 + way.needs.size();
    }
  return masks * system.storedWords * sizeof(Word);
}

std::vector<Word> LiveVariables::maskOf(const Bits& cells) const {
  std::vector<Word> mask(system.storedWords);
  cells.each([&](CellId id) {
    const Cell& cell = system.cells[id];
    if (cell.word < system.storedWords) mask[cell.word] |= cell.mask;
  });
  return mask;
}

void LiveVariables::findMasks(Place& place) const {
  Bits surely;
  for (auto& way : place.ways) {
    Bits rest = way.live;
    way.liveMask = maskOf(way.live);
    for (auto& need : way.needs) {
      rest -= need.rewritten;
      need.rewrittenMask = maskOf(need.rewritten);
    }
    surely |= rest;
  }
  place.surelyLive = maskOf(surely);
  place.writes = maskOf(place.later);
  for (auto node : place.needed) {
    Bits cells;
    addReads(system, node, cells);
    cells.each([&](CellId cell) { place.read.push_back(cell); });
    place.neededCells.push_back(maskOf(cells));
  }
}

/// Finds conditions on a single cell that all paths of a location have in common.
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
  for (std::size_t i = 0; i < all.size(); ++i)
    if (common[i]) all[i].needed = *common[i];
}

/// Finds the paths of each location, with those conditions that show which cells will be written.
void LiveVariables::findWays(const PathsOf& paths, InstanceId instance) {
  for (auto id : paths[instance]) {
    limits->check();
    const Path& path = system.paths[id];
    Way& way = places[instance][path.location].ways.emplace_back(Way{id, {}, path.guardReads});
    way.live |= path.reads;
    Bits conditions;
    for (auto node : conjunctsOf(system, path.guard)) {
      Bits cells;
      addReads(system, node, cells);
      if (cells.count() != 1) continue;
      conditions |= cells;
      way.needs.push_back({node, rewrittenFor(instance, node)});
    }
    std::erase_if(way.needs, [&](Need& need) {
      need.rewritten -= conditions;
      return need.rewritten.empty();
    });
  }
}

/// The cells that every path of another instance surely writes if it may make the condition true.
/// \pre it is a condition on one cell
Bits LiveVariables::rewrittenFor(InstanceId instance, NodeId condition) const {
  Bits read;
  addReads(system, condition, read);
  Bits cells = allCells;
  read.each([&](CellId cell) {
    for (auto id : writing[cell])
      if (system.paths[id].instance != instance && mayMakeTrue(system, system.paths[id], condition))
        for (const auto& [_, sure] : written[id]) cells &= sure;
  });
  return cells;
}

/// Computes live cells backwards along paths, so the last places come first.
void LiveVariables::findLive(std::vector<Place>& all) {
  std::vector<std::vector<std::uint32_t>> before(all.size()); // predecessors of a place
  std::vector<std::uint32_t> todo;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    todo.push_back(i);
    for (const auto& way : all[i].ways)
      for (const auto& [target, _] : written[way.path]) before[target].push_back(i);
  }
  std::vector<bool> isWaiting(all.size(), true);
  while (!todo.empty()) {
    const auto at = todo.back();
    todo.pop_back();
    isWaiting[at] = false;
    bool grew = false;
    for (auto& way : all[at].ways) grew = follow(all, all[at], way) || grew;
    if (!grew) continue;
    for (auto other : before[at])
      if (!isWaiting[other]) {
        isWaiting[other] = true;
        todo.push_back(other);
      }
  }
}

/// Adds to a path the cells that may be read after it. \return whether there are new ones
bool LiveVariables::follow(const std::vector<Place>& all, Place& from, Way& way) {
  limits->check();
  const Path& path = system.paths[way.path];
  Bits live = way.live;
  Bits later = path.writes;
  for (const auto& [target, sure] : written[way.path]) {
    for (const auto& next : all[target].ways) {
      Bits beyond = next.live;
      beyond -= sure;
      for (const auto& need : next.needs)
        if (makesFalse(system, path, sure, need.condition)) beyond -= need.rewritten;
      live |= beyond;
    }
    later |= all[target].later;
  }
  const bool grew = grow(way.live, live);
  return grow(from.later, later) || grew;
}

void LiveVariables::clean(Word* state) const {
  key.resize(system.storedWords);
  findHere(state); // locations are never dead
  while (!isAllLive(state)) {
    for (std::uint32_t i = 0; i < system.storedWords; ++i) key[i] = state[i] & keyMask[i];
    if (key != lastKey) {
      auto [id, isNew] = keys.add(key.data());
      if (isNew) masks.push_back(liveMask(state));
      last = id;
      lastKey = key;
    }
    bool sameKey = true;
    for (std::uint32_t i = 0; i < system.storedWords; ++i) {
      state[i] &= masks[last][i];
      sameKey = sameKey && (state[i] & keyMask[i]) == key[i];
    }
    if (sameKey) return;
  }
}

std::uint64_t LiveVariables::rememberedBytes() const {
  return keys.bytes() +
         masks.size() * (sizeof(std::vector<Word>) + system.storedWords * sizeof(Word));
}

void LiveVariables::forget() const {
  keys = StateStore(system.storedWords);
  masks.clear();
  lastKey.clear();
}

void LiveVariables::findHere(const Word* state) const {
  here.clear();
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    const auto location = readCell(system, system.instances[i].location, state);
    here.push_back(&places[i][static_cast<std::size_t>(location)]);
  }
}

namespace {

bool isPartOf(const std::vector<Word>& some, const std::vector<Word>& of) {
  for (std::size_t k = 0; k < some.size(); ++k)
    if ((some[k] & ~of[k]) != 0) return false;
  return true;
}

/// Whether a cell is among those that are written; never if it has no bits, since it is constant.
bool isWritten(const std::vector<Word>& cell, const std::vector<Word>& written) {
  return isPartOf(cell, written) && std::ranges::any_of(cell, [](Word it) { return it != 0; });
}

} // namespace

/// Whether it is easy to see that no cell is dead: each instance may move sooner or later, and each
/// cell is live for some instance.
bool LiveVariables::isAllLive(const Word* state) const {
  const std::uint32_t words = system.storedWords;
  live = alwaysMask;
  writes.assign(words, 0);
  waiting.clear();
  waitsFor.clear();
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    const Place& place = *here[i];
    for (std::uint32_t k = 0; k < words; ++k) live[k] |= place.surelyLive[k];
    const std::size_t first = waitsFor.size();
    for (std::size_t n = 0; n < place.needed.size(); ++n)
      if (!holds(system, place.needed[n], state)) waitsFor.push_back(&place.neededCells[n]);
    if (waitsFor.size() > first)
      waiting.push_back({&place, first});
    else
      for (std::uint32_t k = 0; k < words; ++k) writes[k] |= place.writes[k];
  }
  return isPartOf(allMask, live) && mayAllMove();
}

/// Whether each instance that waits does so for cells that another may write that may move.
bool LiveVariables::mayAllMove() const {
  for (bool grew = true; grew;) {
    grew = false;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const auto end = i + 1 < waiting.size() ? waiting[i + 1].first : waitsFor.size();
      const Place*& place = waiting[i].place;
      const std::span cells(waitsFor.data() + waiting[i].first, waitsFor.data() + end);
      if (!place || !std::ranges::all_of(cells, [&](auto* it) { return isWritten(*it, writes); }))
        continue;
      for (std::size_t k = 0; k < writes.size(); ++k) writes[k] |= place->writes[k];
      place = nullptr; // it may move
      grew = true;
    }
  }
  return std::ranges::all_of(waiting, [](const Waiting& it) { return !it.place; });
}

/// Finds for each instance that can never move again the cells that keep it from moving. Starts
/// with the assumption that all waiting instances are stuck, and corrects it for those whose cells
/// another instance may still write.
void LiveVariables::findFrozen(const Word* state) const {
  unmet.resize(system.instances.size());
  Bits written;
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    const Place& place = *here[i];
    unmet[i].clear();
    for (std::size_t n = 0; n < place.needed.size(); ++n)
      if (!holds(system, place.needed[n], state)) unmet[i].push_back(place.read[n]);
    if (unmet[i].empty()) written |= place.later;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (InstanceId i = 0; i < system.instances.size(); ++i) {
      if (!dropUnmet(i, written)) continue;
      if (unmet[i].empty()) written |= here[i]->later;
      changed = true;
    }
  }
}

/// Forgets the cells that an instance that may move may write. \return whether there were any
bool LiveVariables::dropUnmet(InstanceId instance, const Bits& written) const {
  return std::erase_if(unmet[instance], [&](CellId it) { return written.contains(it); }) > 0;
}

std::vector<Word> LiveVariables::liveMask(const Word* state) const {
  findFrozen(state);
  std::vector<Word> mask = alwaysMask;
  for (InstanceId i = 0; i < system.instances.size(); ++i) {
    if (unmet[i].empty()) {
      addLive(*here[i], state, mask);
      continue;
    }
    const Cell& cell = system.cells[unmet[i].front()];
    if (cell.word < system.storedWords) mask[cell.word] |= cell.mask;
  }
  return mask;
}

/// Adds the live cells of an instance that may move.
void LiveVariables::addLive(const Place& place, const Word* state, std::vector<Word>& mask) const {
  for (const auto& way : place.ways) {
    own = way.liveMask;
    for (const auto& need : way.needs)
      if (!holds(system, need.condition, state))
        for (std::size_t k = 0; k < own.size(); ++k) own[k] &= ~need.rewrittenMask[k];
    for (std::size_t k = 0; k < own.size(); ++k) mask[k] |= own[k];
  }
}

} // namespace proskill::verify
