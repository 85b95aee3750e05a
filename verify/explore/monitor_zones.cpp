#include "verify/explore/monitor_zones.h"

#include "graph/components.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// Locations on a cycle with an accepting location. A location without edges may be on none.
Bits circlingLocations(const Monitor& monitor) {
  const auto& all = monitor.locations;
  const auto component = graph::componentsOf(all.size(), [&](std::size_t at, std::size_t i) {
    return i < all[at].edges.size() ? all[at].edges[i].to : graph::kNoNode;
  });
  Bits accepting;
  for (std::uint32_t i = 0; i < all.size(); ++i)
    if (all[i].accepting) accepting.insert(component[i]);
  Bits circling;
  for (std::uint32_t i = 0; i < all.size(); ++i)
    if (accepting.contains(component[i])) circling.insert(i);
  return circling;
}

} // namespace

MonitorZones::MonitorZones(const Monitor& of, bool withTicks, const MeasuredClock* measured,
                           LimitWatch& limits)
    : monitor(of), between(limits.asCheck()) {
  if (withTicks) circling = circlingLocations(monitor);
  for (const auto& location : monitor.locations)
    for (const auto& edge : location.edges)
      for (auto limit : {edge.clock.lower, edge.clock.upper})
        if (limit != kInfinite) lower = upper = std::max(lower, std::abs(constantOf(limit)));
  if (measured) { // no guard reads the clock
    lower = measured->longest ? measured->most : -1;
    upper = measured->longest ? -1 : measured->most;
  }
}

std::uint32_t MonitorZones::count(std::uint32_t location) const {
  return (monitor.locations[location].timed ? 1U : 0U) + (ticks(location) ? 1U : 0U);
}

std::optional<Dbm> MonitorZones::settled(Dbm zone, const Signature& signature,
                                         std::uint32_t location, bool instant) const {
  if (!signature.urgent && !instant) zone.up();
  if (!zone.constrainAll(signature.invariants, between)) return std::nullopt;
  auto fromBelow = signature.lower;
  auto fromAbove = signature.upper;
  const auto add = [&](std::int32_t below, std::int32_t above) {
    fromBelow.push_back(below);
    fromAbove.push_back(above);
  };
  if (monitor.locations[location].timed) add(lower, upper);
  if (ticks(location)) add(1, 1);
  zone.extrapolate(fromBelow, fromAbove, between);
  if (!zone.constrainAll(signature.invariants, between)) return std::nullopt;
  return zone;
}

bool MonitorZones::constrain(Dbm& zone, std::uint32_t location, const MonitorEdge& edge) const {
  if (!monitor.locations[location].timed) return true;
  const std::uint32_t clock = zone.dimension() - count(location);
  const auto& guard = edge.clock;
  if (guard.lower != kZero && !zone.constrain(0, clock, guard.lower)) return false;
  return guard.upper == kInfinite || zone.constrain(clock, 0, guard.upper);
}

Dbm MonitorZones::after(const Dbm& zone, std::uint32_t location, const MonitorEdge& edge) const {
  std::vector<std::uint32_t> from;
  for (std::uint32_t i = 1; i < zone.dimension() - count(location); ++i) from.push_back(i);
  appendOwn(from, zone, location, &edge);
  return zone.over(from);
}

void MonitorZones::appendOwn(std::vector<std::uint32_t>& from, const Dbm& zone,
                             std::uint32_t location, const MonitorEdge* edge) const {
  const std::uint32_t to = edge ? edge->to : location;
  const bool goesOn = monitor.locations[location].timed && !(edge && edge->reset);
  if (monitor.locations[to].timed) from.push_back(goesOn ? zone.dimension() - count(location) : 0);
  if (ticks(to)) from.push_back(ticks(location) ? zone.dimension() - 1 : 0);
}

std::optional<Dbm> MonitorZones::ticked(const Dbm& zone, std::uint32_t location) const {
  if (!ticks(location)) return std::nullopt;
  const std::uint32_t clock = zone.dimension() - 1;
  Dbm late = zone;
  if (!late.constrain(0, clock, bound(-1, false))) return std::nullopt;
  std::vector<std::uint32_t> from;
  for (std::uint32_t i = 1; i < clock; ++i) from.push_back(i);
  from.push_back(0);
  return late.over(from);
}

} // namespace proskill::verify
