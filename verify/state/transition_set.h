#pragma once

#include "verify/model/system.h"

#include <algorithm>
#include <bit>

namespace proskill::verify {

/// A set of transitions of a system, as bits.
using TransitionSet = std::vector<Word>;

[[nodiscard]] inline bool contains(const TransitionSet& set, TransitionId id) {
  return (set[id / 64] >> (id % 64) & 1) != 0;
}

inline void insert(TransitionSet& set, TransitionId id) { set[id / 64] |= Word{1} << (id % 64); }

inline void erase(TransitionSet& set, TransitionId id) { set[id / 64] &= ~(Word{1} << (id % 64)); }

/// \pre both sets are of the same system
inline void add(const TransitionSet& more, TransitionSet& set) {
  for (std::size_t i = 0; i < set.size(); ++i) set[i] |= more[i];
}

[[nodiscard]] inline bool isEmpty(const TransitionSet& set) {
  return std::ranges::all_of(set, [](Word bits) { return bits == 0; });
}

template <class Visit> void eachIn(const TransitionSet& set, Visit visit) {
  for (std::size_t i = 0; i < set.size(); ++i)
    for (Word rest = set[i]; rest != 0; rest &= rest - 1)
      visit(static_cast<TransitionId>(i * 64 + std::countr_zero(rest)));
}

/// \pre both sets are of the same system
template <class Visit>
void eachInBoth(const TransitionSet& one, const TransitionSet& other, Visit visit) {
  for (std::size_t i = 0; i < one.size(); ++i)
    for (Word rest = one[i] & other[i]; rest != 0; rest &= rest - 1)
      visit(static_cast<TransitionId>(i * 64 + std::countr_zero(rest)));
}

} // namespace proskill::verify
