#pragma once

#include "verify/space/zone_cover.h"
#include "verify/spill/state_group.h"

namespace proskill::verify {

/// The zones of one state, none of which includes another. Those of a state with many are merged
/// where their union is a zone.
class StateZones {
public:
  void clear() { *this = {}; }
  /// Restores what writeTo() has written.
  void restore(const StateGroup& from, bool areMerged);
  /// Whether they include a zone.
  [[nodiscard]] bool cover(std::span<const Bound> zone) const;
  /// Adds a zone, and removes those that it includes.
  void add(Dbm zone);
  [[nodiscard]] bool areMerged() const { return isCover; }
  [[nodiscard]] const std::vector<Dbm>& all() const { return isCover ? merged.all() : zones; }

private:
  bool isCover = false;
  std::vector<Dbm> zones; ///< the oldest first, unless they are merged
  ZoneCover merged;
};

} // namespace proskill::verify
