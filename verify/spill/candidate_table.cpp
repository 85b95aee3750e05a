#include "verify/spill/candidate_table.h"

#include "verify/model/release.h"
#include <algorithm>

namespace proskill::verify {

CandidateTable::CandidateTable(std::uint32_t wordsOfEach, std::uint64_t bytes)
    : words(wordsOfEach), length(kState + wordsOfEach), slots(kFewestSlots) {
  // a vector that grows needs half as much again for a moment, and slots are half empty
  const std::uint64_t each = length * sizeof(Word) * 3 / 2 + 4 * sizeof(Slot) + sizeof(Place);
  most = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(bytes / each, 4, kNone - 1));
}

std::uint64_t CandidateTable::hashOf(const Word* state, ZoneId zone) const {
  return hashOfAll(std::span(state, words), zone);
}

void CandidateTable::add(const Word* state, ZoneId zone, const Discovery& how) {
  const std::uint64_t hash = hashOf(state, zone);
  const auto tag = static_cast<std::uint32_t>(hash >> 32);
  const std::size_t mask = slots.size() - 1;
  std::size_t place = hash & mask;
  for (; slots[place].number != kNone; place = (place + 1) & mask)
    if (slots[place].tag == tag && static_cast<ZoneId>(at(slots[place].number)[kZone]) == zone &&
        isSame(state, slots[place].number))
      return;
  slots[place] = {count++, tag};
  records.insert(records.end(), {how.parent, how.order, Word{how.step} << 32 | zone});
  records.insert(records.end(), state, state + words);
  if (std::size_t{count} * 2 > slots.size()) grow();
}

void CandidateTable::grow() {
  const std::size_t size = slots.size() * 2;
  verify::release(slots);
  slots.resize(size);
  const std::size_t mask = size - 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint64_t hash = hashOf(stateOf(i), static_cast<ZoneId>(at(i)[kZone]));
    std::size_t place = hash & mask;
    while (slots[place].number != kNone) place = (place + 1) & mask;
    slots[place] = {i, static_cast<std::uint32_t>(hash >> 32)};
  }
}

void CandidateTable::clear() {
  count = 0;
  records.clear();
  order.clear();
  slots.resize(kFewestSlots);
  std::ranges::fill(slots, Slot{});
}

void CandidateTable::release() {
  count = 0;
  verify::release(records);
  verify::release(order);
  slots = std::vector<Slot>(kFewestSlots);
}

void CandidateTable::sort() {
  order.clear();
  order.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) order.push_back({stateOf(i)[0], i});
  std::ranges::sort(order, [&](const Place& a, const Place& b) {
    if (a.first != b.first) return a.first < b.first;
    const auto others = compareStates(stateOf(a.record), stateOf(b.record), words);
    return others != 0 ? others < 0 : a.record < b.record;
  });
}

} // namespace proskill::verify
