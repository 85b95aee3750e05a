#pragma once

#include "verify/model/release.h"
#include "verify/state/store.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace proskill::verify {

/// Cache of results by four numbers. Each new result may take the place of an older one, so its
/// size does not depend on how many there are.
template <class Result> class RecentResults {
public:
  using Key = Memo::Key;

  /// The result for a key, or null. It is valid until the next call of another function.
  [[nodiscard]] const Result* find(const Key& key) const {
    const Entry& entry = entries[placeOf(key)];
    return entry.isUsed && entry.key == key ? &entry.result : nullptr;
  }
  void put(const Key& key, const Result& result) { entries[placeOf(key)] = {key, result, true}; }
  void clear() { entries.assign(entries.size(), {}); }
  /// Makes room for about as many results as the caller has items, within bounds. What was known
  /// may be forgotten.
  void fit(std::size_t items) {
    if (sizeFor(items) <= entries.size()) return;
    release(entries); // before the larger ones are made
    entries.resize(sizeFor(items));
  }
  /// Bytes that fit() will allocate when the caller has a few more items.
  [[nodiscard]] std::uint64_t growth(std::size_t items) const {
    const std::size_t soon = sizeFor(items + kBetweenGrowthChecks);
    return soon > entries.size() ? (soon - entries.size()) * sizeof(Entry) : 0;
  }
  [[nodiscard]] std::uint64_t bytes() const { return entries.capacity() * sizeof(Entry); }

private:
  struct Entry {
    Key key;
    Result result{};
    bool isUsed = false;
  };
  static constexpr std::size_t kFewest = 256;
  static constexpr std::size_t kMost = std::size_t{1} << 19;

  [[nodiscard]] static std::size_t sizeFor(std::size_t items) {
    return std::bit_floor(std::clamp(items, kFewest, kMost));
  }
  [[nodiscard]] std::size_t placeOf(const Key& key) const {
    const auto hash =
        mix(mix(0, std::uint64_t{key.a} << 32 | key.b), std::uint64_t{key.c} << 32 | key.d);
    return (hash >> 32) & (entries.size() - 1);
  }

  LargeVector<Entry> entries = LargeVector<Entry>(kFewest);
};

} // namespace proskill::verify
