#pragma once

#include "verify/model/dbm.h"

#include <optional>
#include <span>
#include <vector>

namespace proskill::verify {

/// The union of the zones of one discrete state. Zones whose union is convex are merged. Ben Salah,
/// Bozga, Maler, "On interleaving in timed automata", CONCUR 2006.
class ZoneCover {
public:
  ZoneCover() = default;
  /// The cover that has these zones: those of another one, in their order.
  explicit ZoneCover(std::vector<Dbm> of) : parts(std::move(of)) {}

  /// Whether one of the merged zones includes this zone.
  [[nodiscard]] bool includesZone(std::span<const Bound> zone) const;
  void add(Dbm zone);
  [[nodiscard]] std::size_t size() const { return parts.size(); }
  [[nodiscard]] const std::vector<Dbm>& all() const { return parts; }
  [[nodiscard]] std::uint64_t bytes() const;

private:
  std::vector<Dbm> parts;
};

/// The least zone that includes two zones. \pre both have the same dimension
[[nodiscard]] Dbm hullOf(const Dbm& a, const Dbm& b);
/// The zone without the bounds that have grown, so that few steps lead from 0 s to a day. Cousot
/// and Cousot, "Abstract interpretation", POPL 1977. \param before a part of the zone \param limits
/// of the clocks, by clock
[[nodiscard]] Dbm widened(const Dbm& before, const Dbm& zone, std::span<const Bound> limits);
/// The union of two zones if it is a zone. \pre both have the same dimension
[[nodiscard]] std::optional<Dbm> convexUnion(const Dbm& a, const Dbm& b);

} // namespace proskill::verify
