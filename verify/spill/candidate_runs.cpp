#include "verify/spill/candidate_runs.h"

#include <algorithm>
#include <numeric>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostRuns = 32;      ///< that are merged at once
constexpr std::uint64_t kShareOfTable = 3; ///< of the memory: one third

} // namespace

CandidateRuns::CandidateRuns(SpillSpace& of, const SpillFormat& how, const ZoneStore& zones)
    : space(of),
      format(how),
      store(zones),
      table(how.words, of.memoryBytes() / kShareOfTable),
      file(std::make_unique<PagedFile>(of)) {}

void CandidateRuns::writeRun() {
  if (table.isEmpty()) return;
  const std::uint64_t begin = file->size();
  std::vector<Word> before(format.words);
  table.eachState([&](const Word* state, std::span<const CandidateTable::Place> places) {
    writeState(*file, before, state);
    const std::uint32_t dimension = store.dimension(table.zoneOf(places[0]));
    file->number(places.size());
    if (format.hasZones) file->number(dimension);
    for (const auto place : places) {
      if (format.hasZones) writeZone(*file, dimension, store.matrix(table.zoneOf(place)));
      writeDiscovery(*file, table.discoveryOf(place));
    }
  });
  table.clear();
  runs.push_back({begin, file->size()});
  if (runs.size() == kMostRuns) mergeRuns();
}

void CandidateRuns::writeDiscovery(PagedFile& to, const Discovery& how) const {
  if (!format.hasDiscoveries) return;
  to.number(how.parent);
  to.number(how.order);
  to.number(how.step + std::uint64_t{1});
}

/// Replaces the runs by one.
void CandidateRuns::mergeRuns() {
  auto merged = std::make_unique<PagedFile>(space);
  std::vector<Word> before(format.words);
  StateGroup group;
  open();
  while (nextOfAll(group)) write(*merged, before, group);
  cursors.clear();
  runs.assign(1, {0, merged->size()});
  file = std::move(merged);
}

void CandidateRuns::write(PagedFile& to, std::vector<Word>& before, const StateGroup& group) const {
  writeState(to, before, group.state.data());
  to.number(group.size());
  if (format.hasZones) to.number(group.dimension);
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (format.hasZones) writeZone(to, group.dimension, group.zone(i));
    if (format.hasDiscoveries) writeDiscovery(to, group.discoveries[i]);
  }
}

void CandidateRuns::open() {
  for (const auto& run : runs) {
    cursors.push_back({PageReader(*file, run.begin, run.end), std::vector<Word>(format.words)});
    advance(cursors.back());
  }
}

void CandidateRuns::advance(Cursor& cursor) const {
  cursor.zones = 0;
  if (cursor.reader.isAtEnd()) return;
  readState(cursor.reader, cursor.state);
  cursor.zones = cursor.reader.number();
  if (format.hasZones) cursor.dimension = static_cast<std::uint32_t>(cursor.reader.number());
}

void CandidateRuns::readZones(Cursor& cursor, StateGroup& to) const {
  to.dimension = cursor.dimension;
  for (; cursor.zones > 0; --cursor.zones) {
    if (format.hasZones)
      readZone(cursor.reader, cursor.dimension, to.bounds);
    else
      to.bounds.push_back(kZero);
    if (!format.hasDiscoveries) continue;
    Discovery how{cursor.reader.number(), cursor.reader.number()};
    how.step = static_cast<TransitionId>(cursor.reader.number() - 1);
    to.discoveries.push_back(how);
  }
}

bool CandidateRuns::next(StateGroup& to) {
  if (cursors.empty()) open();
  if (nextOfAll(to)) return true;
  cursors.clear();
  runs.clear();
  file->clear();
  return false;
}

bool CandidateRuns::nextOfAll(StateGroup& to) {
  const Cursor* first = nullptr;
  for (const auto& cursor : cursors)
    if (cursor.zones != 0 &&
        (!first || compareStates(cursor.state.data(), first->state.data(), format.words) < 0))
      first = &cursor;
  if (!first) return false;
  to.clear();
  to.state = first->state;
  for (auto& cursor : cursors) { // earlier runs first
    if (cursor.zones == 0 || cursor.state != to.state) continue;
    readZones(cursor, to);
    advance(cursor);
  }
  if (to.size() > 1) removeDoubles(to);
  return true;
}

/// Sorts the zones of a state. Of those that are the same, the one that was reached first stays.
void CandidateRuns::removeDoubles(StateGroup& group) {
  order.resize(group.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto isSame = [&](std::uint32_t a, std::uint32_t b) {
    return std::ranges::equal(group.zone(a), group.zone(b));
  };
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return precedes(group.zone(a), group.zone(b));
  });
  const auto doubles = std::ranges::unique(order, isSame);
  order.erase(doubles.begin(), doubles.end());
  sorted.clear();
  for (const auto i : order) {
    const auto zone = group.zone(i);
    sorted.bounds.insert(sorted.bounds.end(), zone.begin(), zone.end());
    if (format.hasDiscoveries) sorted.discoveries.push_back(group.discoveries[i]);
  }
  std::swap(sorted.bounds, group.bounds);
  std::swap(sorted.discoveries, group.discoveries);
}

} // namespace proskill::verify
