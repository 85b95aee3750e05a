#pragma once

#include "verify/limits.h"
#include "verify/model/dbm.h"
#include "verify/model/monitor.h"
#include "verify/state/timing.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace proskill::verify {

/// What a search finds out about the clock of a monitor of durations: monitor/duration_monitor.h.
struct MeasuredClock {
  bool longest = true;   ///< the greatest value during a measurement, or the least at its end
  std::int32_t most = 0; ///< values up to this one are distinguished
  /// Limits x - 0 if `longest`, else 0 - x: over all measurements. Nothing if there is none.
  std::optional<Bound> found{};

  void note(Bound limit) { found = found ? std::max(*found, limit) : limit; }
  /// Whether the result is only known to lie beyond `most`.
  [[nodiscard]] bool isBeyond() const {
    return found && (longest ? *found == kInfinite : *found <= bound(-most, true));
  }
};

/// Zones over the clocks of a system, followed by the clocks of a monitor's location: the monitor's
/// clock if the location is timed, then, if only fair runs count, a clock that detects whether time
/// diverges. A *tick* resets this second clock, at any moment at which its value is at least 1;
/// time diverges in a run with infinitely many ticks. Tripakis, "Verifying progress in timed
/// systems" (ARTS 1999). Locations that are on no cycle with an accepting location need no ticks.
class MonitorZones {
public:
  /// \param withTicks whether divergence of time is detected
  /// \param measured the clock is measured as well
  /// \param limits checked by operations on many clocks
  MonitorZones(const Monitor& of, bool withTicks, const MeasuredClock* measured,
               LimitWatch& limits);

  /// The number of clocks of a location itself.
  [[nodiscard]] std::uint32_t count(std::uint32_t location) const;
  /// Lets time pass as far as the state allows, and abstracts the zone. Nothing if the zone is
  /// empty. \throw LimitMet
  [[nodiscard]] std::optional<Dbm> settled(Dbm zone, const Signature& signature,
                                           std::uint32_t location, bool instant) const;
  /// Restricts the monitor's clock by an edge's guard. Returns false if the zone becomes empty.
  [[nodiscard]] bool constrain(Dbm& zone, std::uint32_t location, const MonitorEdge& edge) const;
  /// The zone after the monitor alone moves along an edge.
  [[nodiscard]] Dbm after(const Dbm& zone, std::uint32_t location, const MonitorEdge& edge) const;
  /// Appends the sources of the target location's clocks, as argument of Dbm::over.
  /// \param edge null: the monitor stays
  void appendOwn(std::vector<std::uint32_t>& from, const Dbm& zone, std::uint32_t location,
                 const MonitorEdge* edge) const;
  /// The zone after a tick; nothing if no tick is possible.
  [[nodiscard]] std::optional<Dbm> ticked(const Dbm& zone, std::uint32_t location) const;

private:
  [[nodiscard]] bool ticks(std::uint32_t location) const { return circling.contains(location); }

  const Monitor& monitor;
  Between between;
  Bits circling; ///< locations on a cycle with an accepting one; only these need ticks
  /// The greatest constants to which the monitor's clock is compared from below and from above.
  std::int32_t lower = 0;
  std::int32_t upper = 0;
};

} // namespace proskill::verify
