#include "verify/state/store.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

void NumberTable::grow() {
  std::vector<Slot> old = std::exchange(slots, std::vector<Slot>(slots.size() * 2));
  const std::uint64_t mask = slots.size() - 1;
  for (const auto& slot : old) {
    if (slot.number == kNone) continue;
    std::uint64_t at = (std::uint64_t{slot.tag} << 32 | slot.low) & mask;
    while (slots[at].number != kNone) at = (at + 1) & mask;
    slots[at] = slot;
  }
}

StateStore::Added StateStore::add(const Word* state) {
  std::uint64_t hash = 0;
  for (std::uint32_t i = 0; i < words; ++i) hash = mix(hash, state[i]);
  hash = mix(hash, hash >> 32);
  auto id = table.findOrAdd(hash, count, [&](StateId other) {
    const Word* known = at(other);
    Word difference = 0; // a few words, so faster than a call
    for (std::uint32_t i = 0; i < words; ++i) difference |= state[i] ^ known[i];
    return difference == 0;
  });
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
