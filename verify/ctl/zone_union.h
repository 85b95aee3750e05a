#pragma once

#include "verify/model/dbm.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// The zone of all values of the clocks.
[[nodiscard]] Dbm allValues(std::uint32_t clocks);

/// A set of clock values: a union of zones over the same clocks.
class ZoneUnion {
public:
  /// Whether one of the zones includes this one.
  [[nodiscard]] bool includesZone(const Dbm& zone) const;
  /// Adds a zone, and drops those that it includes.
  void add(Dbm zone);
  void clear() { zones.clear(); }
  /// A part of `zone` that is outside of all zones of the union; nothing if there is none.
  [[nodiscard]] std::optional<Dbm> outside(Dbm zone) const { return outside(std::move(zone), 0); }
  [[nodiscard]] std::size_t count() const { return zones.size(); }

private:
  [[nodiscard]] std::optional<Dbm> outside(Dbm zone, std::size_t from) const;

  std::vector<Dbm> zones;
};

} // namespace proskill::verify
