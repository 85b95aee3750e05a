#include "verify/spill/state_zones.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr std::size_t kManyZones = 16;

} // namespace

void StateZones::restore(const StateGroup& from, bool areMerged) {
  clear();
  for (std::size_t i = 0; i < from.size(); ++i) zones.emplace_back(from.dimension, from.zone(i));
  isCover = areMerged;
  if (isCover) merged = ZoneCover(std::exchange(zones, {}));
}

bool StateZones::cover(std::span<const Bound> zone) const {
  if (isCover) return merged.includesZone(zone);
  return std::ranges::any_of(zones, [&](const Dbm& it) { return includes(it.matrix(), zone); });
}

void StateZones::add(Dbm zone) {
  if (isCover) return merged.add(std::move(zone));
  std::erase_if(zones, [&](const Dbm& it) { return includes(zone.matrix(), it.matrix()); });
  if (zones.size() < kManyZones) return zones.push_back(std::move(zone));
  isCover = true;
  for (auto it = zones.rbegin(); it != zones.rend(); ++it) merged.add(std::move(*it));
  zones.clear();
  merged.add(std::move(zone));
}

} // namespace proskill::verify
