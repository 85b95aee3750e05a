#include "verify/ctl/zone_union.h"

#include <algorithm>

namespace proskill::verify {

Dbm allValues(std::uint32_t clocks) {
  const std::uint32_t size = clocks + 1;
  std::vector<Bound> entries(std::size_t{size} * size, kInfinite);
  for (std::uint32_t i = 0; i < size; ++i) entries[i] = entries[std::size_t{i} * size + i] = kZero;
  return {size, entries};
}

bool ZoneUnion::includesZone(const Dbm& zone) const {
  return std::ranges::any_of(
      zones, [&](const Dbm& other) { return includes(other.matrix(), zone.matrix()); });
}

void ZoneUnion::add(Dbm zone) {
  std::erase_if(zones, [&](const Dbm& other) { return includes(zone.matrix(), other.matrix()); });
  zones.push_back(std::move(zone));
}

namespace {

bool areDisjoint(const Dbm& a, const Dbm& b) {
  for (std::uint32_t i = 0; i < a.dimension(); ++i)
    for (std::uint32_t j = 0; j < a.dimension(); ++j)
      if (plus(a.at(i, j), b.at(j, i)) < kZero) return true;
  return false;
}

} // namespace

/// What lies outside of the first zone is cut off along one of its bounds after the other.
std::optional<Dbm> ZoneUnion::outside(Dbm zone, std::size_t from) const {
  if (from == zones.size()) return zone;
  const Dbm& first = zones[from];
  if (areDisjoint(zone, first)) return outside(std::move(zone), from + 1);
  for (std::uint32_t i = 0; i < zone.dimension(); ++i)
    for (std::uint32_t j = 0; j < zone.dimension(); ++j) {
      const Bound limit = first.at(i, j);
      if (zone.at(i, j) <= limit) continue;
      Dbm beyond = zone; // not xi - xj <= c is xj - xi < -c
      if (beyond.constrain(j, i, 1 - limit))
        if (auto found = outside(std::move(beyond), from + 1)) return found;
      if (!zone.constrain(i, j, limit)) return std::nullopt;
    }
  return std::nullopt;
}

} // namespace proskill::verify
