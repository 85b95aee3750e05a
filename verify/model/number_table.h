#pragma once

#include "verify/memory/large_vector.h"
#include "verify/model/system.h"

#include <cstdint>
#include <ranges>

/// Hash tables that give each item a number once. The items are kept elsewhere.
namespace proskill::verify {

[[nodiscard]] inline std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15ULL;
  return hash ^ (hash >> 29);
}

/// The hash of some integers. \param seed what else it depends on
[[nodiscard]] std::uint64_t hashOfAll(const std::ranges::input_range auto& numbers,
                                      std::uint64_t seed = 0) {
  for (const auto number : numbers) seed = mix(seed, static_cast<std::uint64_t>(number));
  return mix(seed, seed >> 32);
}

/// A hash table of numbers (open addressing). The owner stores and compares the items. Half of the
/// hash decides the place of an item and is kept with it, so the table grows without the items.
class NumberTable {
public:
  /// The number of the item for which `same` returns true. If there is none, inserts `next` and
  /// returns it.
  template <class Same> std::uint32_t findOrAdd(std::uint64_t hash, std::uint32_t next, Same same) {
    if ((used + 1) * 4 > slots.size() * 3) grow();
    Slot& slot = slots[seek(hash, same)];
    if (slot.number != kNone) return slot.number;
    slot = {next, tagOf(hash)};
    ++used;
    return next;
  }
  /// The number of the item for which `same` returns true; kNone if there is none.
  template <class Same> [[nodiscard]] std::uint32_t find(std::uint64_t hash, Same same) const {
    return slots[seek(hash, same)].number;
  }
  /// Asks the processor to load what the other functions will look at.
  void prefetch(std::uint64_t hash) const { __builtin_prefetch(&slots[placeOf(tagOf(hash))]); }
  /// What find() probably returns for the hash: kNone, if that is not known yet.
  [[nodiscard]] std::uint32_t guess(std::uint64_t hash) const {
    const Slot& slot = slots[placeOf(tagOf(hash))];
    return slot.tag == tagOf(hash) ? slot.number : kNone;
  }
  [[nodiscard]] std::uint64_t bytes() const { return slots.capacity() * sizeof(Slot); }
  [[nodiscard]] std::uint64_t growth() const {
    return (used + kBetweenGrowthChecks) * 4 > slots.size() * 3 ? 2 * bytes() : 0;
  }

private:
  struct Slot {
    std::uint32_t number = kNone;
    std::uint32_t tag = 0;
  };

  [[nodiscard]] static std::uint32_t tagOf(std::uint64_t hash) {
    return static_cast<std::uint32_t>(hash >> 32);
  }
  [[nodiscard]] std::size_t placeOf(std::uint32_t tag) const {
    return static_cast<std::size_t>(std::uint64_t{tag} * slots.size() >> 32);
  }
  /// The slot of the item, or the empty slot for it.
  template <class Same> [[nodiscard]] std::size_t seek(std::uint64_t hash, const Same& same) const {
    const std::uint32_t tag = tagOf(hash);
    std::size_t at = placeOf(tag);
    while (slots[at].number != kNone && (slots[at].tag != tag || !same(slots[at].number)))
      if (++at == slots.size()) at = 0;
    return at;
  }
  void grow();

  LargeVector<Slot> slots = LargeVector<Slot>(256);
  std::uint64_t used = 0;
};

} // namespace proskill::verify
