#pragma once

#include "verify/model/dbm.h"
#include "verify/model/system.h"

#include <span>
#include <vector>

/// Hash tables that store each item once, in one array, and give it a number.
namespace proskill::verify {

[[nodiscard]] inline std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15ULL;
  return hash ^ (hash >> 29);
}

/// Growing tables are checked against the limits at least every so many insertions.
inline constexpr std::size_t kBetweenGrowthChecks = 4096;

/// Additional bytes that a vector will allocate when it grows, if that is soon; otherwise 0.
template <class T> [[nodiscard]] std::uint64_t growthOf(const std::vector<T>& all) {
  if (all.capacity() - all.size() > kBetweenGrowthChecks) return 0;
  return all.capacity() * sizeof(T);
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

  std::vector<Slot> slots = std::vector<Slot>(256);
  std::uint64_t used = 0;
};

using StateId = std::uint32_t;
using ZoneId = std::uint32_t;

/// Discrete states, packed.
class StateStore {
public:
  explicit StateStore(std::uint32_t wordsOfEach) : words(wordsOfEach) {}

  struct Added {
    StateId id = 0;
    bool isNew = false;
  };
  Added add(const Word* state);
  /// The number of a state, or kNone.
  [[nodiscard]] StateId find(const Word* state) const {
    return table.find(hashOf(state), [&](StateId other) { return isEqual(state, other); });
  }
  [[nodiscard]] const Word* at(StateId id) const { return arena.data() + std::size_t{id} * words; }
  [[nodiscard]] std::uint32_t size() const { return count; }
  [[nodiscard]] std::uint64_t bytes() const {
    return table.bytes() + arena.capacity() * sizeof(Word);
  }
  [[nodiscard]] std::uint64_t growth() const { return table.growth() + growthOf(arena); }

private:
  [[nodiscard]] std::uint64_t hashOf(const Word* state) const;
  [[nodiscard]] bool isEqual(const Word* state, StateId other) const;

  std::uint32_t words;
  std::uint32_t count = 0;
  std::vector<Word> arena;
  NumberTable table;
};

/// Zones by their matrices.
class ZoneStore {
public:
  ZoneId add(const Dbm& zone);
  /// The number of a zone; kNone if it is not stored.
  [[nodiscard]] ZoneId find(std::span<const Bound> zone) const;
  [[nodiscard]] std::span<const Bound> matrix(ZoneId id) const {
    const Place& place = places[id];
    return {arena.data() + place.offset, std::size_t{place.dimension} * place.dimension};
  }
  [[nodiscard]] std::uint32_t dimension(ZoneId id) const { return places[id].dimension; }
  [[nodiscard]] Dbm zone(ZoneId id) const { return {places[id].dimension, matrix(id)}; }
  [[nodiscard]] Bound at(ZoneId id, std::uint32_t i, std::uint32_t j) const {
    const Place& place = places[id];
    return arena[place.offset + std::size_t{i} * place.dimension + j];
  }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(places.size()); }
  [[nodiscard]] std::uint64_t bytes() const {
    return table.bytes() + arena.capacity() * sizeof(Bound) + places.capacity() * sizeof(Place);
  }
  [[nodiscard]] std::uint64_t growth() const {
    return table.growth() + growthOf(arena) + growthOf(places);
  }

private:
  struct Place {
    std::uint64_t offset = 0;
    std::uint32_t dimension = 0;
  };

  [[nodiscard]] static std::uint64_t hashOf(std::span<const Bound> zone);
  [[nodiscard]] bool isEqual(std::span<const Bound> zone, ZoneId other) const;

  std::vector<Place> places;
  std::vector<Bound> arena;
  NumberTable table;
};

/// Cache of computed numbers, by four numbers.
class Memo {
public:
  struct Key {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t c = 0;
    std::uint32_t d = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  /// The value for `key`; computed by `make` on the first call. Nothing is kept if `make` throws.
  template <class Make> std::uint32_t get(const Key& key, Make make) {
    std::uint64_t hash =
        mix(mix(0, std::uint64_t{key.a} << 32 | key.b), std::uint64_t{key.c} << 32 | key.d);
    const auto isSame = [&](std::uint32_t i) { return keys[i] == key; };
    if (const auto at = table.find(hash, isSame); at != kNone) return values[at];
    const std::uint32_t made = make();
    table.findOrAdd(hash, static_cast<std::uint32_t>(keys.size()), isSame);
    keys.push_back(key);
    values.push_back(made);
    return made;
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return table.bytes() + keys.capacity() * sizeof(Key) +
           values.capacity() * sizeof(std::uint32_t);
  }
  [[nodiscard]] std::uint64_t growth() const {
    return table.growth() + growthOf(keys) + growthOf(values);
  }

private:
  std::vector<Key> keys;
  std::vector<std::uint32_t> values;
  NumberTable table;
};

} // namespace proskill::verify
