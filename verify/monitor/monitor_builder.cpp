#include "verify/monitor/monitor_builder.h"

namespace proskill::verify {

using fiacre::Interval;

bool hasZero(const Interval& interval) { return interval.lower == 0 && !interval.lowerOpen; }

ClockGuard withinInterval(const Interval& interval) {
  return {lowerBound(interval), upperBound(interval)};
}

ClockGuard beforeInterval(const Interval& interval) {
  return {kZero, bound(interval.lower, !interval.lowerOpen)};
}

ClockGuard sinceInterval(const Interval& interval) { return {lowerBound(interval), kInfinite}; }

ClockGuard afterInterval(const Interval& interval) {
  return {bound(-*interval.upper, !interval.upperOpen), kInfinite};
}

ClockGuard lessThan(std::int64_t time) { return {kZero, bound(time, true)}; }

bool MonitorBuilder::isUntimed() const {
  return !pattern.within && !pattern.forInterval && !pattern.forDuration && !pattern.lasting;
}

std::optional<Interval> MonitorBuilder::interval() const {
  if (pattern.forDuration || pattern.lasting || (pattern.within && pattern.forInterval))
    return std::nullopt;
  if (pattern.within) return pattern.within;
  return pattern.forInterval ? *pattern.forInterval : Interval{};
}

LocationId MonitorBuilder::addLocation(NodeId stay, bool timed, ClockGuard clock) {
  const auto added = static_cast<LocationId>(made.locations.size());
  made.locations.push_back({.stay = stay, .timed = timed});
  step(added, added, stay, clock);
  return added;
}

LocationId MonitorBuilder::addError() {
  made.locations.push_back({.stay = yes(), .error = true});
  return static_cast<LocationId>(made.locations.size() - 1);
}

void MonitorBuilder::step(LocationId from, LocationId to, NodeId condition, ClockGuard clock,
                          bool reset) {
  made.locations[from].edges.push_back({true, to, condition, clock, reset});
}

void MonitorBuilder::silent(LocationId from, LocationId to, NodeId condition, ClockGuard clock,
                            bool reset) {
  made.locations[from].edges.push_back({false, to, condition, clock, reset});
}

void MonitorBuilder::go(LocationId from, LocationId to, NodeId condition, ClockGuard clock,
                        bool reset) {
  silent(from, to, condition, clock, reset);
  step(from, to, condition, clock, reset);
}

MonitorBuilder::Wait MonitorBuilder::wait(NodeId good, const Interval& when, LocationId lost,
                                          NodeId outside) {
  Wait wait;
  wait.now = addLocation(both(outside, no(good)), when.upper.has_value());
  if (when.upper) {
    wait.late = lost;
    silent(wait.now, lost, yes(), afterInterval(when));
  } else {
    made.locations[wait.now].accepting = true;
  }
  if (hasZero(when)) return wait;
  wait.early = addLocation(outside, true, beforeInterval(when));
  made.locations[wait.early].accepting = !when.upper; // time may never get there
  silent(wait.early, wait.now, no(good), sinceInterval(when));
  if (pattern.first) // too early is a violation as well
    go(wait.early, lost, good, beforeInterval(when));
  return wait;
}

void MonitorBuilder::begin(LocationId from, const Wait& wait, NodeId when, NodeId good,
                           LocationId lost) {
  const bool atOnce = wait.early == kNone;
  go(from, wait.first(), atOnce || pattern.first ? both(when, no(good)) : when, {}, true);
  if (!atOnce && pattern.first) go(from, lost, both(when, good));
}

MonitorBuilder::Wait MonitorBuilder::waitWithin(NodeId good, const Interval& when, LocationId late,
                                                NodeId end, LocationId lost) {
  const Wait waits = wait(good, when, late, no(end));
  for (auto at : {waits.now, waits.first()})
    if (!pattern.until || pattern.between) made.locations[at].accepting = false; // it has to come
  go(waits.now, lost, end);
  // The good event has come in time: the monitor may stay here until something happens.
  if (waits.early != kNone) go(waits.early, lost, end, beforeInterval(when));
  return waits;
}

} // namespace proskill::verify
