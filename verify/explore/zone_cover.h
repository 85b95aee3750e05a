#pragma once

#include "verify/model/dbm.h"

#include <optional>
#include <span>
#include <vector>

namespace proskill::verify {

/// What many zones of one discrete state cover together: zones whose union is convex are one. Ben
/// Salah, Bozga, Maler, "On interleaving in timed automata", CONCUR 2006.
class ZoneCover {
public:
  /// Whether one of the parts includes the zone.
  [[nodiscard]] bool includesZone(std::span<const Bound> zone) const;
  void add(Dbm zone);
  [[nodiscard]] std::size_t size() const { return parts.size(); }
  [[nodiscard]] std::uint64_t bytes() const;

private:
  std::vector<Dbm> parts;
};

/// The union of two zones where that is a zone. \pre same dimension
[[nodiscard]] std::optional<Dbm> convexUnion(const Dbm& a, const Dbm& b);

} // namespace proskill::verify
