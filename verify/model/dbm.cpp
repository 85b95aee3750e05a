#include "verify/model/dbm.h"

#include <algorithm>

namespace proskill::verify {

bool Dbm::constrain(std::uint32_t i, std::uint32_t j, Bound limit) {
  if (at(i, j) <= limit) return true;
  if (plus(limit, at(j, i)) < kZero) return false;
  entry(i, j) = limit;
  for (std::uint32_t a = 0; a < size; ++a) {
    const Bound toI = plus(at(a, i), limit);
    if (toI == kInfinite) continue;
    for (std::uint32_t b = 0; b < size; ++b) entry(a, b) = std::min(at(a, b), plus(toI, at(j, b)));
  }
  return true;
}

void Dbm::up() {
  for (std::uint32_t i = 1; i < size; ++i) entry(i, 0) = kInfinite;
}

Dbm Dbm::over(std::span<const std::uint32_t> from) const {
  Dbm made(static_cast<std::uint32_t>(from.size()));
  const auto old = [&](std::uint32_t i) { return i == 0 ? 0 : from[i - 1]; };
  for (std::uint32_t i = 0; i < made.size; ++i)
    for (std::uint32_t j = 0; j < made.size; ++j) made.entry(i, j) = at(old(i), old(j));
  return made;
}

bool Dbm::constrainAll(std::span<const Bound> limits, const Between& between) {
  for (std::uint32_t k = 0; k < limits.size(); ++k) {
    if (between && size >= kManyClocks) between();
    if (!constrain(k + 1, 0, limits[k])) return false;
  }
  return true;
}

void Dbm::extrapolate(std::span<const std::int32_t> lower, std::span<const std::int32_t> upper,
                      const Between& between) {
  const auto beyond = [&](std::uint32_t i, std::int32_t limit) {
    return i != 0 && (limit < 0 || -constantOf(at(0, i)) > limit);
  };
  bool changed = false;
  for (std::uint32_t i = size; i-- > 0;) { // the first row is read for all others
    for (std::uint32_t j = 0; j < size; ++j) {
      if (i == j) continue;
      Bound made = at(i, j);
      if (i == 0 && beyond(j, upper[j])) made = upper[j] < 0 ? kZero : bound(-upper[j], true);
      if (i != 0 && (beyond(i, lower[i]) || made > bound(lower[i], false) || beyond(j, upper[j])))
        made = kInfinite;
      changed = changed || made != at(i, j);
      entry(i, j) = made;
    }
  }
  if (changed) close(between);
}

void Dbm::startAt(std::uint32_t i) {
  for (std::uint32_t k = 0; k < size; ++k) std::swap(entry(0, k), entry(i, k));
  for (std::uint32_t k = 0; k < size; ++k) std::swap(entry(k, 0), entry(k, i));
}

void Dbm::startBefore() {
  for (std::uint32_t j = 1; j < size; ++j) {
    Bound least = kZero;
    for (std::uint32_t i = 1; i < size; ++i) least = std::min(least, at(i, j));
    entry(0, j) = least;
  }
}

void Dbm::replace(std::uint32_t i, Bound lower, Bound upper) {
  for (std::uint32_t j = 0; j < size; ++j) {
    if (j == i) continue;
    entry(i, j) = plus(upper, at(0, j));
    entry(j, i) = plus(at(j, 0), lower);
  }
}

bool Dbm::close(const Between& between) {
  for (std::uint32_t k = 0; k < size; ++k) {
    if (between && size >= kManyClocks) between();
    for (std::uint32_t i = 0; i < size; ++i) {
      const Bound first = at(i, k);
      if (first == kInfinite) continue;
      for (std::uint32_t j = 0; j < size; ++j)
        entry(i, j) = std::min(at(i, j), plus(first, at(k, j)));
    }
  }
  for (std::uint32_t i = 0; i < size; ++i)
    if (at(i, i) < kZero) return false;
  return true;
}

bool includes(std::span<const Bound> outer, std::span<const Bound> inner) {
  for (std::size_t i = 0; i < outer.size(); ++i)
    if (inner[i] > outer[i]) return false;
  return true;
}

} // namespace proskill::verify
