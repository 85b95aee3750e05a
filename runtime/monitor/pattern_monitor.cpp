#include "runtime/monitor/pattern_monitor.h"

#include <algorithm>

namespace proskill::runtime {

using verify::Moment;
using verify::MonitorEdge;
using verify::Word;

namespace {

constexpr std::size_t kMostRanges = 1'000; ///< in a location
constexpr std::size_t kMostZones = 10'000; ///< in a stay
constexpr std::int64_t kNoViolation = -1;
constexpr std::int64_t kNoLimit = INT64_MAX;
/// The clock is not used.
constexpr DateRange kUnused{};

bool seenIn(const verify::System& system, verify::NodeId condition, const Word* state) {
  return holdsAt(system, condition, {state, nullptr, nullptr});
}

bool isNever(const verify::System& system, verify::NodeId condition) {
  const auto& node = system.nodes[condition];
  return node.op == verify::NodeOp::Number && node.number == 0;
}

} // namespace

PatternMonitor::PatternMonitor(const verify::System& of, const verify::Monitor& with,
                               Nanoseconds in)
    : system(of),
      monitor(with),
      unit(in),
      limits(with.locations.size(), kNoViolation),
      resets(with.locations.size()),
      next(with.locations.size()) {
  for (const auto& location : monitor.locations)
    for (const auto& edge : location.edges)
      for (const auto bound : {edge.clock.lower, edge.clock.upper})
        if (bound != verify::kInfinite && bound != verify::kZero)
          most = std::max(most, std::abs(verify::constantOf(bound)) * unit);
  findLimits();
}

/// Computes the limits as the least fixed point over the edges.
void PatternMonitor::findLimits() {
  for (std::uint32_t i = 0; i < limits.size(); ++i)
    if (monitor.locations[i].error || monitor.locations[i].accepting) limits[i] = kNoLimit;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = 0; i < limits.size(); ++i)
      for (const auto& edge : monitor.locations[i].edges) {
        const auto limit = limitBy(i, edge);
        changed = changed || limit > limits[i];
        limits[i] = std::max(limits[i], limit);
      }
  }
}

std::int64_t PatternMonitor::limitBy(std::uint32_t from, const MonitorEdge& edge) const {
  const auto behind = limits[edge.to];
  if (behind == kNoViolation || isNever(system, edge.condition)) return kNoViolation;
  if (!monitor.locations[from].timed) return kNoLimit;
  const auto upper = inDates(edge.clock.upper);
  const auto here = upper == kNoBound ? kNoLimit : upper - 1;
  return edge.reset ? here : std::min(here, behind);
}

DateBound PatternMonitor::inDates(verify::Bound bound) const {
  if (bound == verify::kInfinite) return kNoBound;
  return 2 * (verify::constantOf(bound) * unit) + (bound & 1);
}

void PatternMonitor::start(const Word* state) {
  for (const auto location : monitor.initial) add(resets, location, kUnused);
  wait(state, 0);
}

void PatternMonitor::wait(const Word* state, Nanoseconds until) {
  if (firstError || isLost || isEmpty) return;
  if (restsIn(state)) {
    now = until;
    return forgetOld();
  }
  const auto stay = stayIn(state, until);
  firstError = stay.error;
  isLost = stay.isTooLarge && !firstError;
  for (auto& ranges : next) ranges.clear();
  for (const auto& [location, zone] : stay.all)
    if (seenIn(system, monitor.locations[location].stay, state))
      if (const auto range = zone.resetsAt(until))
        add(next, location, monitor.locations[location].timed ? *range : kUnused);
  std::swap(resets, next);
  now = until;
  forgetOld();
}

/// Whether the monitor does nothing but wait.
bool PatternMonitor::restsIn(const Word* state) const {
  for (std::uint32_t i = 0; i < resets.size(); ++i) {
    const auto& location = monitor.locations[i];
    if (resets[i].empty()) continue;
    if (location.error || !seenIn(system, location.stay, state)) return false;
    for (const auto& edge : location.edges)
      if (!edge.ofStep && seenIn(system, edge.condition, state)) return false;
  }
  return true;
}

PatternMonitor::Stay PatternMonitor::stayIn(const Word* state,
                                            std::optional<Nanoseconds> until) const {
  Stay stay;
  for (std::uint32_t i = 0; i < resets.size(); ++i)
    for (const auto& range : resets[i]) addTo(stay, {i, DateZone(now, range)});
  for (std::size_t i = 0; i < stay.all.size() && !stay.isTooLarge; ++i) {
    const auto& location = monitor.locations[stay.all[i].location];
    if (location.error) {
      const auto date = stay.all[i].zone.earliest();
      stay.error = std::min(stay.error.value_or(date), date);
      continue;
    }
    if (seenIn(system, location.stay, state)) stay.all[i].zone.elapse(until);
    for (const auto& edge : location.edges)
      if (!edge.ofStep && seenIn(system, edge.condition, state))
        if (auto found = moved(stay.all[i], edge)) addTo(stay, *found);
    stay.isTooLarge = stay.all.size() > kMostZones;
  }
  return stay;
}

void PatternMonitor::addTo(Stay& stay, Found found) {
  const auto isKnown = [&](const Found& known) {
    return known.location == found.location && known.zone.includes(found.zone);
  };
  if (std::ranges::none_of(stay.all, isKnown)) stay.all.push_back(found);
}

/// The monitor after an edge, in the same moment; nullopt: the clock does not allow it.
std::optional<PatternMonitor::Found> PatternMonitor::moved(const Found& from,
                                                           const MonitorEdge& edge) const {
  Found to{edge.to, from.zone};
  const bool isTimed = monitor.locations[from.location].timed;
  if (isTimed && !to.zone.constrainClock(inDates(edge.clock.lower), inDates(edge.clock.upper)))
    return std::nullopt;
  if (!isTimed || edge.reset || !monitor.locations[edge.to].timed) to.zone.reset();
  return to;
}

void PatternMonitor::step(const Moment& moment) {
  if (firstError || isLost || isEmpty) return;
  for (auto& ranges : next) ranges.clear();
  for (std::uint32_t i = 0; i < resets.size(); ++i) {
    if (resets[i].empty()) continue;
    for (const auto& edge : monitor.locations[i].edges) {
      if (!edge.ofStep || !holdsAt(system, edge.condition, moment)) continue;
      for (const auto& range : resets[i])
        if (const auto found = moved({i, DateZone(now, range)}, edge))
          add(next, edge.to,
              monitor.locations[edge.to].timed ? *found->zone.resetsAt(now) : kUnused);
    }
  }
  std::swap(resets, next);
  wait(moment.after, now);
}

/// Adds dates to a location's; ranges that touch become one.
void PatternMonitor::add(std::vector<std::vector<DateRange>>& to, std::uint32_t location,
                         DateRange range) {
  auto& ranges = to[location];
  std::erase_if(ranges, [&](const DateRange& other) {
    if (other.first > range.last + 1 || range.first > other.last + 1) return false;
    range = {std::min(range.first, other.first), std::max(range.last, other.last)};
    return true;
  });
  ranges.push_back(range);
  isLost = isLost || ranges.size() > kMostRanges;
}

/// Forgets values of the clock from which no violation can follow, and makes those equal that no
/// guard distinguishes.
void PatternMonitor::forgetOld() {
  isEmpty = true;
  const auto oldest = 2 * (now - most - 1);
  for (std::uint32_t i = 0; i < resets.size(); ++i) {
    if (limits[i] == kNoViolation) resets[i].clear();
    if (monitor.locations[i].timed) {
      if (limits[i] != kNoLimit)
        std::erase_if(resets[i],
                      [&](const DateRange& range) { return 2 * now - range.last > limits[i]; });
      for (auto& range : resets[i])
        range = {std::max(range.first, oldest), std::max(range.last, oldest)};
    }
    isEmpty = isEmpty && resets[i].empty();
  }
}

std::optional<Nanoseconds> PatternMonitor::nextDecision(const Word* state) const {
  if (firstError || isLost || isEmpty || most < 0) return std::nullopt;
  const auto stay = stayIn(state, std::nullopt);
  if (stay.error) return std::max(*stay.error, now);
  Nanoseconds last = now;
  for (std::uint32_t i = 0; i < resets.size(); ++i) {
    if (resets[i].empty()) continue;
    if (!monitor.locations[i].timed || limits[i] == kNoLimit) return std::nullopt;
    for (const auto& range : resets[i]) last = std::max(last, (limits[i] + range.last) / 2 + 1);
  }
  return last;
}

} // namespace proskill::runtime
