#include "verify/spill/visited_states.h"

#include <algorithm>

namespace proskill::verify {

VisitedStates::VisitedStates(SpillSpace& of, const SpillFormat& how) : space(of), format(how) {}

std::shared_ptr<const VisitedRun> VisitedStates::add(CandidateRuns& candidates,
                                                     const OnNew& onNew) {
  auto made = std::make_shared<VisitedRun>(space, format);
  for (const auto& run : runs) cursors.emplace_back(*run);
  StateGroup group;
  while (candidates.next(group)) addState(group, *made, onNew);
  cursors.clear();
  runs.push_back(made);
  mergeSmall();
  return made;
}

void VisitedStates::addState(const StateGroup& group, VisitedRun& to, const OnNew& onNew) {
  kept.clear();
  kept.state = group.state;
  kept.dimension = group.dimension;
  if (format.inclusion && format.hasZones)
    keepUncovered(group, onNew);
  else
    keepUnknown(group, onNew);
  if (kept.size() != 0) write(kept, zones.areMerged(), to);
}

/// The zones of a state are those of all runs together.
void VisitedStates::keepUnknown(const StateGroup& group, const OnNew& onNew) {
  isKnown.assign(group.size(), false);
  bool isNewState = true;
  for (auto& cursor : cursors) {
    if (!cursor.find(group.state.data())) continue;
    isNewState = false;
    earlier.clear();
    cursor.readZones(earlier);
    for (std::size_t i = 0; i < earlier.size(); ++i)
      for (std::size_t j = 0; j < group.size(); ++j)
        if (!isKnown[j]) isKnown[j] = std::ranges::equal(earlier.zone(i), group.zone(j));
  }
  if (isNewState) ++stateCount;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (isKnown[i]) continue;
    noteNew(group, i, onNew);
    kept.bounds.insert(kept.bounds.end(), group.zone(i).begin(), group.zone(i).end());
  }
}

/// The zones of a state are those of the newest run that has it.
void VisitedStates::keepUncovered(const StateGroup& group, const OnNew& onNew) {
  zones.clear();
  bool isNewState = true;
  for (auto cursor = cursors.rbegin(); cursor != cursors.rend() && isNewState; ++cursor) {
    if (!cursor->find(group.state.data())) continue;
    isNewState = false;
    earlier.clear();
    cursor->readZones(earlier);
    zones.restore(earlier, cursor->entry().areMerged);
  }
  if (isNewState) ++stateCount;
  bool isChanged = false;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (zones.cover(group.zone(i))) continue;
    noteNew(group, i, onNew);
    zones.add({group.dimension, group.zone(i)});
    isChanged = true;
  }
  if (!isChanged) return;
  for (const auto& zone : zones.all())
    kept.bounds.insert(kept.bounds.end(), zone.matrix().begin(), zone.matrix().end());
}

void VisitedStates::noteNew(const StateGroup& group, std::size_t i, const OnNew& onNew) {
  ++nodeCount;
  onNew(group, i);
}

void VisitedStates::write(const StateGroup& group, bool areMerged, VisitedRun& to) {
  text.bytes.clear();
  for (std::size_t i = 0; i < group.size(); ++i) writeZone(text, group.dimension, group.zone(i));
  entry.state = group.state;
  entry.zones = group.size();
  entry.areMerged = areMerged;
  entry.dimension = group.dimension;
  to.add(entry, text.bytes);
}

/// Afterwards each run is less than half as long as the one before.
void VisitedStates::mergeSmall() {
  while (runs.size() > 1 && runs.back()->size() * 2 >= runs[runs.size() - 2]->size()) {
    Run merged = merge(*runs[runs.size() - 2], *runs.back());
    runs.pop_back();
    runs.back() = std::move(merged);
  }
}

VisitedStates::Run VisitedStates::merge(const VisitedRun& older, const VisitedRun& newer) {
  auto made = std::make_shared<VisitedRun>(space, format);
  VisitedRun::Cursor one(older);
  VisitedRun::Cursor other(newer);
  one.next();
  other.next();
  std::string bytes;
  while (!one.isAtEnd() || !other.isAtEnd()) {
    auto order = std::strong_ordering::less;
    if (one.isAtEnd())
      order = std::strong_ordering::greater;
    else if (!other.isAtEnd())
      order = compareStates(one.entry().state.data(), other.entry().state.data(), format.words);
    bytes.clear();
    entry = order < 0 ? one.entry() : other.entry();
    if (order < 0 || (order == 0 && !format.inclusion)) one.readZones(bytes);
    if (order >= 0) other.readZones(bytes);
    if (order == 0 && !format.inclusion) entry.zones += one.entry().zones;
    made->add(entry, bytes);
    if (order <= 0) one.next();
    if (order >= 0) other.next();
  }
  return made;
}

std::uint64_t VisitedStates::bytes() const {
  std::uint64_t all = 0;
  for (const auto& run : runs) all += run->bytes();
  return all;
}

} // namespace proskill::verify
