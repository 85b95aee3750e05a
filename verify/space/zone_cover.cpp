#include "verify/space/zone_cover.h"

#include <algorithm>

namespace proskill::verify {

/// The greater of each two bounds: these are tight if those of both zones are.
Dbm hullOf(const Dbm& a, const Dbm& b) {
  std::vector<Bound> bounds(a.matrix().begin(), a.matrix().end());
  for (std::size_t i = 0; i < bounds.size(); ++i) bounds[i] = std::max(bounds[i], b.matrix()[i]);
  return {a.dimension(), bounds};
}

Dbm widened(const Dbm& before, const Dbm& zone, std::span<const Bound> limits) {
  const std::uint32_t size = zone.dimension();
  std::vector<Bound> bounds(zone.matrix().begin(), zone.matrix().end());
  for (std::size_t i = 0; i < bounds.size(); ++i)
    if (bounds[i] > before.matrix()[i]) bounds[i] = i < size ? kZero : kInfinite;
  Dbm wide(size, bounds);
  wide.close();
  wide.constrainAll(limits);
  return wide;
}

std::optional<Dbm> convexUnion(const Dbm& a, const Dbm& b) {
  const std::uint32_t size = a.dimension();
  Dbm hull = hullOf(a, b);
  for (std::uint32_t i = 0; i < size; ++i)
    for (std::uint32_t j = 0; j < size; ++j) {
      if (a.at(i, j) == hull.at(i, j)) continue;
      Dbm outside = hull; // the complement of xi - xj <= c is xj - xi < -c
      if (!outside.constrain(j, i, 1 - a.at(i, j))) continue;
      if (!includes(b.matrix(), outside.matrix())) return std::nullopt;
    }
  return hull;
}

bool ZoneCover::includesZone(std::span<const Bound> zone) const {
  return std::ranges::any_of(parts, [&](const Dbm& part) { return includes(part.matrix(), zone); });
}

void ZoneCover::add(Dbm zone) {
  constexpr std::size_t kTried = 8; // number of the newest parts
  for (bool joined = true; joined;) {
    joined = false;
    for (std::size_t i = parts.size(); i-- > 0 && i + kTried >= parts.size() && !joined;) {
      auto whole = convexUnion(parts[i], zone);
      if (!whole) continue;
      zone = std::move(*whole);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
      joined = true;
    }
  }
  parts.push_back(std::move(zone));
}

std::uint64_t ZoneCover::bytes() const {
  const std::uint64_t each = parts.empty() ? 0 : parts.front().matrix().size_bytes();
  return parts.capacity() * sizeof(Dbm) + parts.size() * each;
}

} // namespace proskill::verify
