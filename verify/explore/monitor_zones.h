#pragma once

#include "verify/model/dbm.h"
#include "verify/model/monitor.h"
#include "verify/state/timing.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// Zones of a system's clocks, and behind them those of a monitor's location: its own where the
/// location is timed, then, where only fair runs count, one that tells whether time goes on. That
/// one starts anew by a *tick*, at any moment at which it is at least 1; a run with ticks again and
/// again is one in which time diverges. Tripakis, "Verifying progress in timed systems" (ARTS
/// 1999). Locations that no accepting one can be reached from and lead to again need no ticks.
class MonitorZones {
public:
  /// \param withTicks whether it is told if time goes on
  MonitorZones(const Monitor& of, bool withTicks);

  /// How many clocks a location has of its own.
  [[nodiscard]] std::uint32_t count(std::uint32_t location) const;
  /// Lets time pass as far as the state allows it, and forgets what nothing compares any more.
  /// Nothing where the zone is empty.
  [[nodiscard]] std::optional<Dbm> settled(Dbm zone, const Signature& signature,
                                           std::uint32_t location, bool instant) const;
  /// Limits the monitor's clock by an edge's guard. False where nothing is left.
  [[nodiscard]] bool constrain(Dbm& zone, std::uint32_t location, const MonitorEdge& edge) const;
  /// The zone when the monitor alone moves along an edge.
  [[nodiscard]] Dbm after(const Dbm& zone, std::uint32_t location, const MonitorEdge& edge) const;
  /// For Dbm::over: where the clocks of the location behind come from. \param edge nothing: it
  /// stays
  void appendOwn(std::vector<std::uint32_t>& from, const Dbm& zone, std::uint32_t location,
                 const MonitorEdge* edge) const;
  /// Behind a tick; nothing where there can be none.
  [[nodiscard]] std::optional<Dbm> ticked(const Dbm& zone, std::uint32_t location) const;

private:
  [[nodiscard]] bool ticks(std::uint32_t location) const { return circling.contains(location); }

  const Monitor& monitor;
  Bits circling;         ///< locations on a cycle with an accepting one, where ticks count
  std::int32_t most = 0; ///< the largest constant that the monitor's clock is compared with
};

} // namespace proskill::verify
