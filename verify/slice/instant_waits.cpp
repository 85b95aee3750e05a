#include "verify/slice/instant_waits.h"

#include "verify/model/nodes.h"
#include "verify/model/value_bounds.h"
#include "verify/reduce/path_facts.h"
#include "verify/state/evaluate.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostCombinations = 4096;
constexpr std::int64_t kMostPossible = 256;

using CellValues = std::set<std::int64_t>;

bool add(CellValues& to, const CellValues& more) {
  const auto before = to.size();
  to.insert(more.begin(), more.end());
  return to.size() != before;
}

/// The possible values of cells at each end of a path, from those before it.
std::map<std::uint32_t, CellValues> valuesAfter(const System& system, const Path& path, CellId cell,
                                                const CellValues& before, const CellValues& all) {
  const auto assign = [&](CellValues& values, const Assignment& assignment) {
    if (assignment.target != cell) return;
    const Node& value = system.nodes[assignment.value];
    values = value.op == NodeOp::Number ? CellValues{value.number} : all;
  };
  return alongPath(path, before, assign, add);
}

} // namespace

InstantWaits::InstantWaits(const System& of, LimitWatch& watch)
    : system(of),
      limits(watch),
      evaluation(of),
      writer(of.cells.size(), kNone),
      pathsOf(of.instances.size()),
      urgentOf(of.instances.size()),
      state(of.words),
      unknown(of.words, ~Word{0}) {
  Bits shared;
  for (PathId i = 0; i < system.paths.size(); ++i) {
    const Path& path = system.paths[i];
    pathsOf[path.instance].push_back(i);
    path.writes.each([&](CellId cell) {
      if (writer[cell] != kNone && writer[cell] != path.instance) shared.insert(cell);
      writer[cell] = path.instance;
    });
  }
  shared.each([&](CellId cell) { writer[cell] = kNone; });
  for (TransitionId i = 0; i < system.transitions.size(); ++i)
    if (system.transitions[i].urgent && !system.transitions[i].tentative)
      for (auto part : system.transitions[i].parts)
        urgentOf[system.paths[part].instance].push_back(i);
}

void InstantWaits::set(CellId id, std::int64_t value) {
  writeCell(system, id, value, state.data());
  unknown[system.cells[id].word] &= ~system.cells[id].mask;
}

void InstantWaits::forget(CellId id) { unknown[system.cells[id].word] |= system.cells[id].mask; }

bool InstantWaits::isInstant(NodeId condition) {
  const auto [entry, isNew] = decided.try_emplace(condition, false);
  if (!isNew || mayFail(system, condition)) return entry->second;
  Bits read;
  addReads(system, condition, read);
  std::vector<CellId> cells;
  std::int64_t choices = 1;
  read.each([&](CellId cell) {
    cells.push_back(cell);
    const auto values = system.cells[cell].high - system.cells[cell].low + 1;
    choices = values > kMostCombinations ? kMostCombinations + 1
                                         : std::min(choices * values, kMostCombinations + 1);
  });
  if (cells.empty() || choices > kMostCombinations) return false;
  bool all = true;
  for (std::int64_t choice = 0; choice < choices && all; ++choice) {
    limits.check();
    auto rest = choice;
    for (auto cell : cells) {
      const auto& of = system.cells[cell];
      const auto count = of.high - of.low + 1;
      set(cell, of.low + rest % count);
      rest /= count;
    }
    all = holds(system, condition, state.data()) || isUrgentWith(cells);
  }
  std::ranges::for_each(cells, [&](CellId cell) { forget(cell); });
  return entry->second = all;
}

bool InstantWaits::holdsAt(NodeId condition, InstanceId instance, std::uint32_t location) {
  Bits read;
  addReads(system, condition, read);
  if (read.count() != 1 || mayFail(system, condition)) return false;
  CellId cell = 0;
  read.each([&](CellId only) { cell = only; });
  if (writer[cell] != instance) return false;
  const auto& values = valuesAt(cell);
  if (values.empty()) return false;
  const bool all = std::ranges::all_of(values[location], [&](std::int64_t value) {
    set(cell, value);
    return holds(system, condition, state.data());
  });
  forget(cell);
  return all;
}

/// Whether an urgent transition is possible for these values of the cells: one of the same
/// instance, in each location in which the instance may then be.
bool InstantWaits::isUrgentWith(const std::vector<CellId>& cells) {
  std::map<InstanceId, Bits> places;
  for (auto cell : cells) {
    const auto instance = writer[cell];
    if (instance == kNone) continue;
    const Bits here = locationsWith(instance, cell, readCell(system, cell, state.data()));
    places.try_emplace(instance, here).first->second &= here;
  }
  return std::ranges::any_of(places, [&](const auto& place) {
    bool all = true;
    place.second.each(
        [&](std::uint32_t location) { all = all && someIsEnabled(place.first, location); });
    return all;
  });
}

bool InstantWaits::someIsEnabled(InstanceId instance, std::uint32_t location) {
  const CellId cell = system.instances[instance].location;
  const bool isKnown = (unknown[system.cells[cell].word] & system.cells[cell].mask) == 0;
  const auto before = readCell(system, cell, state.data());
  set(cell, location);
  const bool found = std::ranges::any_of(urgentOf[instance], [&](TransitionId id) {
    BitField undecided;
    return !system.transitions[id].fails &&
           evaluation.guard(system, system.transitions[id], {state.data(), unknown.data()},
                            undecided) == PartialTruth::True;
  });
  set(cell, before);
  if (!isKnown) forget(cell);
  return found;
}

/// The locations in which the only writer of a cell may be while the cell has a value.
Bits InstantWaits::locationsWith(InstanceId instance, CellId cell, std::int64_t value) {
  Bits locations;
  if (cell == system.instances[instance].location) {
    locations.insert(static_cast<std::uint32_t>(value));
    return locations;
  }
  const auto& values = valuesAt(cell);
  for (std::uint32_t i = 0; i < system.instances[instance].locations.size(); ++i)
    if (values.empty() || values[i].contains(value)) locations.insert(i);
  return locations;
}

/// The possible values of a cell while its only writer is in each location; empty: any.
const std::vector<CellValues>& InstantWaits::valuesAt(CellId cell) {
  const auto [entry, isNew] = known.try_emplace(cell);
  const Cell& of = system.cells[cell];
  if (!isNew || of.high - of.low >= kMostPossible) return entry->second;
  const InstanceId instance = writer[cell];
  auto& values = entry->second;
  values.resize(system.instances[instance].locations.size());
  CellValues all;
  for (auto value = of.low; value <= of.high; ++value) all.insert(value);
  const auto start = system.cells[system.instances[instance].location].initial;
  values[static_cast<std::size_t>(start)].insert(of.initial);
  for (bool grew = true; grew;) {
    grew = false;
    for (auto id : pathsOf[instance]) {
      const Path& path = system.paths[id];
      if (values[path.location].empty()) continue;
      limits.check();
      for (const auto& [to, after] : valuesAfter(system, path, cell, values[path.location], all))
        grew = add(values[to], after) || grew;
    }
  }
  return values;
}

} // namespace proskill::verify
