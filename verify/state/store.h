#pragma once

#include "verify/model/dbm.h"
#include "verify/model/number_table.h"
#include "verify/model/system.h"

#include <algorithm>
#include <span>
#include <vector>

/// Hash tables that store each item once, in one array, and give it a number.
namespace proskill::verify {

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
  LargeVector<Word> arena;
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
    return table.growth() + growthOf(arena, std::max(kBetweenGrowthChecks, largest)) +
           growthOf(places);
  }

private:
  struct Place {
    std::uint64_t offset = 0;
    std::uint32_t dimension = 0;
  };

  [[nodiscard]] static std::uint64_t hashOf(std::span<const Bound> zone);
  [[nodiscard]] bool isEqual(std::span<const Bound> zone, ZoneId other) const;

  LargeVector<Place> places;
  LargeVector<Bound> arena;
  std::size_t largest = 0; ///< bounds of a zone
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
  LargeVector<Key> keys;
  LargeVector<std::uint32_t> values;
  NumberTable table;
};

} // namespace proskill::verify
