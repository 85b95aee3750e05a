#include "verify/model/dbm.h"
#include "verify/space/zone_cover.h"

#include <catch2/catch.hpp>

#include <random>

using namespace proskill::verify;

namespace {

/// Values of clocks, in eighths.
using Point = std::vector<int>;
constexpr int kParts = 8;

bool contains(const Dbm& zone, const Point& point) {
  const auto value = [&](std::uint32_t i) { return i == 0 ? 0 : point[i - 1]; };
  for (std::uint32_t i = 0; i < zone.dimension(); ++i)
    for (std::uint32_t j = 0; j < zone.dimension(); ++j) {
      const Bound limit = zone.at(i, j);
      if (limit == kInfinite) continue;
      const int difference = value(i) - value(j);
      const int most = constantOf(limit) * kParts;
      if (difference > most || (difference == most && limit % 2 == 0)) return false;
    }
  return true;
}

/// Calls `visit` with every point of two clocks up to `most` units, `step` eighths apart.
template <class Visit> void eachPoint(int most, int step, Visit visit) {
  for (int x = 0; x <= most * kParts; x += step)
    for (int y = 0; y <= most * kParts; y += step) visit(Point{x, y});
}

class Zones {
public:
  explicit Zones(unsigned seed) : random(seed) {}

  int upTo(int most) { return std::uniform_int_distribution<>(0, most)(random); }
  Bound anyBound(int low, int high) { return bound(low + upTo(high - low), upTo(1) == 0); }

  /// A non-empty zone of two clocks with constants up to 4.
  Dbm any() {
    while (true) {
      Dbm zone(2);
      zone.up();
      std::vector<std::uint32_t> from{upTo(1) == 0 ? 1U : 0U, 2U};
      zone = zone.over(from);
      zone.up();
      bool some = true;
      for (int i = upTo(4); i > 0 && some; --i) {
        auto a = static_cast<std::uint32_t>(upTo(2));
        auto b = static_cast<std::uint32_t>(upTo(2));
        if (a != b) some = zone.constrain(a, b, anyBound(b == 0 ? 0 : -4, a == 0 ? 0 : 4));
      }
      if (some) return zone;
    }
  }

private:
  std::mt19937 random;
};

constexpr int kZones = 300;

} // namespace

TEST_CASE("Adding a bound keeps exactly the points that meet it") {
  Zones zones(1);
  for (int n = 0; n < kZones; ++n) {
    const Dbm zone = zones.any();
    auto i = static_cast<std::uint32_t>(zones.upTo(2));
    auto j = (i + 1 + static_cast<std::uint32_t>(zones.upTo(1))) % 3;
    const Bound limit = zones.anyBound(-4, 4);
    Dbm less = zone;
    const bool some = less.constrain(i, j, limit);
    bool found = false;
    eachPoint(6, 2, [&](const Point& point) {
      const int difference = (i == 0 ? 0 : point[i - 1]) - (j == 0 ? 0 : point[j - 1]);
      const int most = constantOf(limit) * kParts;
      const bool meets = difference < most || (difference == most && limit % 2 != 0);
      const bool expected = meets && contains(zone, point);
      found = found || expected;
      if (some) REQUIRE(contains(less, point) == expected);
      if (!some) REQUIRE_FALSE(expected);
    });
    Dbm closed = less;
    if (some) REQUIRE(closed.close());
    if (some) CHECK(std::ranges::equal(closed.matrix(), less.matrix()));
  }
}

TEST_CASE("Letting time pass moves along the diagonal") {
  Zones zones(2);
  for (int n = 0; n < kZones; ++n) {
    const Dbm zone = zones.any();
    Dbm later = zone;
    later.up();
    eachPoint(6, 2, [&](const Point& point) {
      bool expected = false;
      for (int delay = 0; delay <= std::min(point[0], point[1]); ++delay)
        expected = expected || contains(zone, {point[0] - delay, point[1] - delay});
      REQUIRE(contains(later, point) == expected);
    });
  }
}

TEST_CASE("Dropping a clock and starting another") {
  Zones zones(3);
  for (int n = 0; n < kZones; ++n) {
    const Dbm zone = zones.any();
    const Dbm other = zone.over(std::vector<std::uint32_t>{2, 0});
    eachPoint(4, 2, [&](const Point& point) {
      bool expected = false;
      for (int x = 0; x <= 12 * kParts && point[1] == 0; ++x)
        expected = expected || contains(zone, {x, point[0]});
      REQUIRE(contains(other, point) == expected);
    });
  }
}

TEST_CASE("Extrapolation adds only points that some old point can imitate") {
  Zones zones(4);
  for (int n = 0; n < 60; ++n) {
    const Dbm zone = zones.any();
    std::vector<std::int32_t> lower{-1, zones.upTo(3) - 1, zones.upTo(3) - 1};
    std::vector<std::int32_t> upper{-1, zones.upTo(3) - 1, zones.upTo(3) - 1};
    Dbm wider = zone;
    wider.extrapolate(lower, upper);
    // Clock by clock: the same value, or one that no lower bound, or no upper bound, can
    // distinguish.
    const auto imitates = [&](const Point& old, const Point& made) {
      for (std::size_t i = 0; i < 2; ++i) {
        const int l = lower[i + 1] < 0 ? -1 : lower[i + 1] * kParts;
        const int u = upper[i + 1] < 0 ? -1 : upper[i + 1] * kParts;
        const bool less = l < old[i] && old[i] < made[i];
        const bool more = u < made[i] && made[i] < old[i];
        if (old[i] != made[i] && !less && !more) return false;
      }
      return true;
    };
    eachPoint(5, 4, [&](const Point& made) {
      if (contains(zone, made)) REQUIRE(contains(wider, made));
      if (!contains(wider, made)) return;
      bool found = false;
      eachPoint(9, 1, [&](const Point& old) {
        found = found || (imitates(old, made) && contains(zone, old));
      });
      REQUIRE(found);
    });
  }
}

TEST_CASE("Inclusion is inclusion of points") {
  Zones zones(5);
  for (int n = 0; n < kZones; ++n) {
    const Dbm a = zones.any();
    const Dbm b = zones.any();
    bool all = true;
    eachPoint(12, 4, [&](const Point& point) {
      all = all && (!contains(b, point) || contains(a, point));
    });
    if (includes(a.matrix(), b.matrix())) CHECK(all);
    if (!all) CHECK_FALSE(includes(a.matrix(), b.matrix()));
    CHECK(includes(a.matrix(), a.matrix()));
  }
}

TEST_CASE("A firing domain that starts at its first delay") {
  Dbm domain(2);
  domain.replace(1, bound(-1, false), bound(3, false));
  domain.replace(2, bound(-2, false), bound(5, true));
  REQUIRE(domain.constrain(1, 2, kZero)); // the first fires before the second
  domain.startAt(1);
  const Dbm rest = domain.over(std::vector<std::uint32_t>{2});
  CHECK(rest.at(0, 1) == kZero);
  CHECK(rest.at(1, 0) == bound(4, true));
}

TEST_CASE("Two zones are joined only where that adds no point") {
  Zones zones(6);
  int joined = 0;
  for (int n = 0; n < 4 * kZones; ++n) {
    const Dbm a = zones.any();
    Dbm b = a;
    if (!b.constrain(1, 0, zones.anyBound(0, 4)) || n % 3 == 0) b = zones.any();
    const auto whole = convexUnion(a, b);
    if (!whole) continue;
    ++joined;
    eachPoint(6, 2, [&](const Point& point) {
      REQUIRE(contains(*whole, point) == (contains(a, point) || contains(b, point)));
    });
  }
  CHECK(joined > 20);
  Dbm first(1);
  first.up();
  Dbm second = first;
  REQUIRE(first.constrain(1, 0, bound(3, false)));
  REQUIRE(second.constrain(0, 1, bound(-3, true)));
  CHECK(convexUnion(first, second)); // up to 3, and above 3
  REQUIRE(first.constrain(1, 0, bound(3, true)));
  CHECK_FALSE(convexUnion(first, second)); // 3 itself is missing
}

TEST_CASE("A cover includes what one of its zones, or a union of them, includes") {
  ZoneCover cover;
  const auto between = [](std::int64_t low, std::int64_t high) {
    Dbm zone(1);
    zone.up();
    REQUIRE(zone.constrain(0, 1, bound(-low, false)));
    REQUIRE(zone.constrain(1, 0, bound(high, false)));
    return zone;
  };
  cover.add(between(0, 2));
  cover.add(between(6, 8));
  CHECK(cover.size() == 2);
  CHECK_FALSE(cover.includesZone(between(1, 5).matrix()));
  cover.add(between(2, 6)); // fills the gap
  CHECK(cover.size() == 1);
  CHECK(cover.includesZone(between(1, 7).matrix()));
  CHECK_FALSE(cover.includesZone(between(1, 9).matrix()));
}
