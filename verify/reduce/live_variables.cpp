#include "verify/reduce/live_variables.h"

#include "verify/model/conjuncts.h"
#include "verify/model/nodes.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"

#include <algorithm>

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
    : system(of), limits(watch), keyMask(of.storedWords), keys(of.storedWords) {
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
    limits.check();
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
  tells.each([&](CellId id) {
    const Cell& cell = system.cells[id];
    if (cell.word < system.storedWords) keyMask[cell.word] |= cell.mask;
  });
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
    limits.check();
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
  std::vector<bool> waiting(all.size(), true);
  while (!todo.empty()) {
    const auto at = todo.back();
    todo.pop_back();
    waiting[at] = false;
    bool grew = false;
    for (auto& way : all[at].ways) grew = follow(all, all[at], way) || grew;
    if (!grew) continue;
    for (auto other : before[at])
      if (!waiting[other]) {
        waiting[other] = true;
        todo.push_back(other);
      }
  }
}

/// Adds to a path the cells that may be read after it. \return whether there are new ones
bool LiveVariables::follow(const std::vector<Place>& all, Place& from, Way& way) {
  limits.check();
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
/// others. Starts with the assumption that all waiting instances are stuck, and corrects it for
/// those whose cells another instance may still write.
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
    if (!needs[i].empty()) {
      live |= needs[i];
      continue;
    }
    for (const auto& way : place.ways) {
      Bits own = way.live;
      for (const auto& need : way.needs)
        if (!holds(system, need.condition, state)) own -= need.rewritten;
      live |= own;
    }
  }
  std::vector<Word> mask(system.storedWords);
  live.each([&](CellId id) {
    const Cell& cell = system.cells[id];
    if (cell.word < system.storedWords) mask[cell.word] |= cell.mask;
  });
  return mask;
}

} // namespace proskill::verify
