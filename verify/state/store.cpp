#include "verify/state/store.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

std::uint64_t StateStore::hashOf(const Word* state) const {
  return hashOfAll(std::span(state, words));
}

bool StateStore::isEqual(const Word* state, StateId other) const {
  const Word* known = at(other);
  Word difference = 0; // a few words, so faster than a call
  for (std::uint32_t i = 0; i < words; ++i) difference |= state[i] ^ known[i];
  return difference == 0;
}

StateStore::Added StateStore::add(const Word* state) {
  auto id =
      table.findOrAdd(hashOf(state), count, [&](StateId other) { return isEqual(state, other); });
  if (id != count) return {id, false};
  arena.insert(arena.end(), state, state + words);
  ++count;
  return {id, true};
}

std::uint64_t ZoneStore::hashOf(std::span<const Bound> zone) {
  return hashOfAll(zone, zone.size());
}

bool ZoneStore::isEqual(std::span<const Bound> zone, ZoneId other) const {
  return std::ranges::equal(matrix(other), zone);
}

ZoneId ZoneStore::add(const Dbm& zone) {
  const auto entries = zone.matrix();
  const auto id = table.findOrAdd(hashOf(entries), size(),
                                  [&](ZoneId other) { return isEqual(entries, other); });
  if (id != size()) return id;
  places.push_back({arena.size(), zone.dimension()});
  arena.insert(arena.end(), entries.begin(), entries.end());
  largest = std::max(largest, entries.size());
  return id;
}

ZoneId ZoneStore::find(std::span<const Bound> zone) const {
  return table.find(hashOf(zone), [&](ZoneId other) { return isEqual(zone, other); });
}

} // namespace proskill::verify
