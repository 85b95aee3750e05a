#pragma once

#include "verify/state/store.h"

#include <algorithm>
#include <vector>

namespace proskill::verify {

/// States and zones that a rank has sent lately. Neighbouring nodes often have a successor in
/// common, which is then sent once. Each slot holds the last of those that share it.
class RecentlySent {
public:
  /// \param words of each state
  explicit RecentlySent(std::uint32_t words)
      : words(words), states(kSlots * words), zones(kSlots, kNone) {}

  /// Notes what is about to be sent. \return whether it is not known to have been sent before
  bool note(const Word* state, ZoneId zone) {
    const std::size_t slot = slotOf(state, zone);
    Word* const last = states.data() + slot * words;
    if (zones[slot] == zone && std::equal(last, last + words, state)) return false;
    std::copy_n(state, words, last);
    zones[slot] = zone;
    return true;
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return states.capacity() * sizeof(Word) + zones.capacity() * sizeof(ZoneId);
  }

private:
  static constexpr std::size_t kSlots = std::size_t{1} << 15;

  [[nodiscard]] std::size_t slotOf(const Word* state, ZoneId zone) const {
    return hashOfAll(std::span(state, words), zone) % kSlots;
  }

  std::uint32_t words;
  std::vector<Word> states; ///< by slot
  std::vector<ZoneId> zones;
};

} // namespace proskill::verify
