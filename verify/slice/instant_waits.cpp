#include "verify/slice/instant_waits.h"

#include "verify/model/nodes.h"
#include "verify/state/evaluate.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::int64_t kMostCombinations = 4096;
constexpr std::int64_t kMostPossible = 256;

using Values = std::set<std::int64_t>;

bool add(Values& to, const Values& more) {
  const auto before = to.size();
  to.insert(more.begin(), more.end());
  return to.size() != before;
}

/// What a cell may hold at each end of a path, from what it holds before: by target.
std::map<std::uint32_t, Values> valuesBehind(const System& system, const Path& path, CellId cell,
                                             const Values& before, const Values& all) {
  std::vector<Values> at(path.code.size());
  std::map<std::uint32_t, Values> ends;
  if (at.empty()) return ends;
  at[0] = before;
  for (bool grew = true; grew;) { // code may jump back
    grew = false;
    for (std::size_t i = 0; i < path.code.size(); ++i) {
      const auto& instruction = path.code[i];
      Values now = at[i];
      bool goesOn = true;
      switch (instruction.kind) {
      case InstructionKind::Assign:
      case InstructionKind::Store:
        for (auto k = instruction.first; k < instruction.last && !now.empty(); ++k) {
          const auto& assignment = path.assignments[k];
          if (assignment.target != cell) continue;
          const Node& value = system.nodes[assignment.value];
          now = value.op == NodeOp::Number ? Values{value.number} : all;
        }
        break;
      case InstructionKind::JumpUnless: grew = add(at[instruction.last], now) || grew; break;
      case InstructionKind::Jump:
        grew = add(at[instruction.last], now) || grew;
        goesOn = false;
        break;
      case InstructionKind::To:
        add(ends[instruction.last], now);
        goesOn = false;
        break;
      case InstructionKind::Loop:
        add(ends[path.location], now);
        goesOn = false;
        break;
      case InstructionKind::On:
      case InstructionKind::Tag:
      case InstructionKind::Origin:
      case InstructionKind::Fail: break;
      }
      if (goesOn && i + 1 < at.size()) grew = add(at[i + 1], now) || grew;
    }
  }
  return ends;
}

} // namespace

InstantWaits::InstantWaits(const System& of, LimitWatch& watch)
    : system(of),
      limits(watch),
      evaluation(of),
      writer(of.cells.size(), kNone),
      urgentOf(of.instances.size()),
      state(of.words),
      unknown(of.words, ~Word{0}) {
  Bits shared;
  for (const auto& path : system.paths)
    path.writes.each([&](CellId cell) {
      if (writer[cell] != kNone && writer[cell] != path.instance) shared.insert(cell);
      writer[cell] = path.instance;
    });
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

/// Whether an urgent transition is possible where the cells hold what they are set to: one of the
/// same instance wherever that may be then.
bool InstantWaits::isUrgentWith(const std::vector<CellId>& cells) {
  std::map<InstanceId, Bits> places;
  for (auto cell : cells) {
    const auto instance = writer[cell];
    if (instance == kNone) continue;
    const Bits here = locationsWith(instance, cell, readCell(system, cell, state.data()));
    const auto [entry, isNew] = places.try_emplace(instance, here);
    if (isNew) continue;
    Bits outside = entry->second;
    outside -= here;
    entry->second -= outside;
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

/// Where the only writer of a cell may be while it has a value.
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

/// What a cell may hold while its only writer is in each location; empty: anything.
const std::vector<Values>& InstantWaits::valuesAt(CellId cell) {
  const auto [entry, isNew] = known.try_emplace(cell);
  const Cell& of = system.cells[cell];
  if (!isNew || of.high - of.low >= kMostPossible) return entry->second;
  const InstanceId instance = writer[cell];
  auto& values = entry->second;
  values.resize(system.instances[instance].locations.size());
  Values all;
  for (auto value = of.low; value <= of.high; ++value) all.insert(value);
  const auto start = system.cells[system.instances[instance].location].initial;
  values[static_cast<std::size_t>(start)].insert(of.initial);
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& path : system.paths) {
      if (path.instance != instance || values[path.location].empty()) continue;
      limits.check();
      for (const auto& [to, behind] : valuesBehind(system, path, cell, values[path.location], all))
        grew = add(values[to], behind) || grew;
    }
  }
  return values;
}

} // namespace proskill::verify
