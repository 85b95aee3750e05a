#pragma once

#include "verify/model/monitor.h"
#include "verify/model/nodes.h"
#include "verify/state/timing.h"

#include "fiacre/syntax/tree.h"

#include <optional>

namespace proskill::verify {

using LocationId = std::uint32_t;

/// Guards of a monitor's clock, by an interval of a pattern.
[[nodiscard]] bool hasZero(const fiacre::Interval& interval);
[[nodiscard]] ClockGuard withinInterval(const fiacre::Interval& interval);
/// Less than the interval's dates.
[[nodiscard]] ClockGuard beforeInterval(const fiacre::Interval& interval);
/// As late as its dates, or later.
[[nodiscard]] ClockGuard sinceInterval(const fiacre::Interval& interval);
/// Later than its dates. \pre it has an end
[[nodiscard]] ClockGuard afterInterval(const fiacre::Interval& interval);
[[nodiscard]] ClockGuard lessThan(std::int64_t time);

/// What monitors of patterns are made of: locations, moves, and waiting in vain. `go` moves at a
/// point where a condition holds, be it a state or a step; the location that it moves to begins
/// with that very point.
class MonitorBuilder {
protected:
  MonitorBuilder(const fiacre::Pattern& of, Nodes& in) : pattern(of), nodes(in) {}

  [[nodiscard]] bool isUntimed() const;
  /// What `within` or `for interval` says, where that is all; else nothing.
  [[nodiscard]] std::optional<fiacre::Interval> interval() const;

  [[nodiscard]] NodeId no(NodeId node) { return nodes.negation(node); }
  [[nodiscard]] NodeId both(NodeId x, NodeId y) { return nodes.both(x, y); }
  [[nodiscard]] NodeId yes() { return nodes.number(1); }

  /// A location in which every point fulfils `stay`.
  LocationId addLocation(NodeId stay, bool timed = false, ClockGuard clock = {});
  LocationId addError();
  void step(LocationId from, LocationId to, NodeId condition, ClockGuard clock = {},
            bool reset = false);
  void silent(LocationId from, LocationId to, NodeId condition, ClockGuard clock = {},
              bool reset = false);
  void go(LocationId from, LocationId to, NodeId condition, ClockGuard clock = {},
          bool reset = false);
  void start(LocationId at) { made.initial.push_back(at); }

  /// Where a run waits in vain: nothing good comes while the clock is in the interval.
  struct Wait {
    LocationId early = kNone; ///< before the interval; kNone where it begins at once
    LocationId now = 0;       ///< within it; `first` comes here where there is no `early`
    LocationId late = kNone;  ///< behind it, `lost` where nothing else is asked; kNone: unbounded
    [[nodiscard]] LocationId first() const { return early == kNone ? now : early; }
  };

  /// \param outside what holds all the time \param good what is not to come within the interval
  Wait wait(NodeId good, const fiacre::Interval& when, LocationId lost, NodeId outside);
  /// Waits in vain within a part of a run: up to its end, too.
  Wait waitWithin(NodeId good, const fiacre::Interval& when, LocationId late, NodeId end,
                  LocationId lost);
  /// Begins to wait at a point where `when` holds.
  void begin(LocationId from, const Wait& wait, NodeId when, NodeId good, LocationId lost);

  const fiacre::Pattern& pattern;
  Nodes& nodes;
  Monitor made;
};

} // namespace proskill::verify
