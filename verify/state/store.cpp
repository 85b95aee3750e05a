#include "verify/state/store.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

void NumberTable::grow() {
  const std::vector<Slot> old = std::exchange(slots, std::vector<Slot>(slots.size() * 2));
  for (const auto& slot : old) {
    if (slot.number == kNone) continue;
    std::size_t at = placeOf(slot.tag);
    while (slots[at].number != kNone)
      if (++at == slots.size()) at = 0;
    slots[at] = slot;
  }
}

std::uint64_t StateStore::hashOf(const Word* state) const {
  std::uint64_t hash = 0;
  for (std::uint32_t i = 0; i < words; ++i) hash = mix(hash, state[i]);
  return mix(hash, hash >> 32);
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

ZoneId ZoneStore::add(const Dbm& zone) {
  auto entries = zone.matrix();
  std::uint64_t hash = zone.dimension();
  for (auto entry : entries) hash = mix(hash, static_cast<std::uint32_t>(entry));
  hash = mix(hash, hash >> 32);
  auto id = table.findOrAdd(
      hash, size(), [&](ZoneId other) { return std::ranges::equal(matrix(other), entries); });
  if (id != size()) return id;
  places.push_back({arena.size(), zone.dimension()});
  arena.insert(arena.end(), entries.begin(), entries.end());
  return id;
}

} // namespace proskill::verify
