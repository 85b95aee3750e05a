#pragma once

#include "verify/spill/state_group.h"
#include "verify/state/store.h"

namespace proskill::verify {

/// States and zones that were reached lately, each once: of those that are the same, the first
/// stays. Zones are numbers of a ZoneStore.
class CandidateTable {
public:
  /// \param words of each state \param bytes that it may have
  CandidateTable(std::uint32_t words, std::uint64_t bytes);

  /// \pre not isFull()
  void add(const Word* state, ZoneId zone, const Discovery& how);
  [[nodiscard]] bool isFull() const { return count == most; }
  [[nodiscard]] bool isEmpty() const { return count == 0; }
  void clear();
  /// Removes everything, and gives the memory back.
  void release();
  [[nodiscard]] std::uint64_t bytes() const {
    return records.capacity() * sizeof(Word) + slots.capacity() * sizeof(Slot) +
           order.capacity() * sizeof(Place);
  }

  /// Visits the states in their order, each with its zones.
  /// \param visit takes a state and a function that returns how many zones it has, and one for each
  template <class Visit> void eachState(Visit visit) {
    sort();
    for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
      const Word* const state = stateOf(order[i].record);
      for (end = i; end < order.size() && isSame(state, order[end].record);) ++end;
      visit(state, std::span(order).subspan(i, end - i));
    }
  }

  /// A record, with the first word of its state.
  struct Place {
    Word first = 0;
    std::uint32_t record = 0;
  };
  [[nodiscard]] ZoneId zoneOf(Place place) const {
    return static_cast<ZoneId>(at(place.record)[kZone]);
  }
  [[nodiscard]] Discovery discoveryOf(Place place) const {
    const Word* record = at(place.record);
    return {record[kParent], record[kOrder], static_cast<TransitionId>(record[kZone] >> 32)};
  }

private:
  struct Slot {
    std::uint32_t number = kNone;
    std::uint32_t tag = 0;
  };
  // a record: how it was reached, the step and the zone, the state
  static constexpr std::size_t kParent = 0;
  static constexpr std::size_t kOrder = 1;
  static constexpr std::size_t kZone = 2;
  static constexpr std::size_t kState = 3;
  static constexpr std::size_t kFewestSlots = 64;

  [[nodiscard]] const Word* at(std::uint32_t record) const {
    return records.data() + record * length;
  }
  [[nodiscard]] const Word* stateOf(std::uint32_t record) const { return at(record) + kState; }
  [[nodiscard]] bool isSame(const Word* state, std::uint32_t record) const {
    return std::equal(state, state + words, stateOf(record));
  }
  [[nodiscard]] std::uint64_t hashOf(const Word* state, ZoneId zone) const;
  void insert(std::uint64_t hash, std::uint32_t number);
  void grow();
  void sort();

  std::uint32_t words;
  std::size_t length; ///< number of words of a record
  std::uint32_t most; ///< records
  std::uint32_t count = 0;
  std::vector<Word> records;
  std::vector<Slot> slots;
  std::vector<Place> order;
};

} // namespace proskill::verify
