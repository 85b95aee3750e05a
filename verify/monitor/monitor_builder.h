#pragma once

#include "verify/model/monitor.h"
#include "verify/model/nodes.h"
#include "verify/state/timing.h"

#include "fiacre/syntax/tree.h"

#include <optional>

namespace proskill::verify {

using LocationId = std::uint32_t;

/// Guards on a monitor's clock, from an interval of a pattern.
[[nodiscard]] bool hasZero(const fiacre::Interval& interval);
[[nodiscard]] ClockGuard withinInterval(const fiacre::Interval& interval);
/// The clock is before the interval.
[[nodiscard]] ClockGuard beforeInterval(const fiacre::Interval& interval);
/// The clock is in the interval or after it.
[[nodiscard]] ClockGuard sinceInterval(const fiacre::Interval& interval);
/// The clock is after the interval. \pre the interval has an upper bound
[[nodiscard]] ClockGuard afterInterval(const fiacre::Interval& interval);
[[nodiscard]] ClockGuard lessThan(std::int64_t time);

/// Builds monitors of patterns from locations, moves and waits. `go` adds a move at a point, a
/// state or a step, where a condition holds; the target location starts at this very point.
class MonitorBuilder {
protected:
  MonitorBuilder(const fiacre::Pattern& of, Nodes& in) : pattern(of), nodes(in) {}

  [[nodiscard]] bool isUntimed() const;
  /// The interval of the pattern's `within` or `for`, if it has one and nothing else.
  [[nodiscard]] std::optional<fiacre::Interval> interval() const;

  [[nodiscard]] NodeId no(NodeId node) { return nodes.negation(node); }
  [[nodiscard]] NodeId both(NodeId x, NodeId y) { return nodes.both(x, y); }
  [[nodiscard]] NodeId yes() { return nodes.number(1); }

  /// A location in which `stay` holds at every point.
  LocationId addLocation(NodeId stay, bool timed = false, ClockGuard clock = {});
  LocationId addError();
  void step(LocationId from, LocationId to, NodeId condition, ClockGuard clock = {},
            bool reset = false);
  void silent(LocationId from, LocationId to, NodeId condition, ClockGuard clock = {},
              bool reset = false);
  void go(LocationId from, LocationId to, NodeId condition, ClockGuard clock = {},
          bool reset = false);
  void start(LocationId at) { made.initial.push_back(at); }

  /// The locations in which a run waits in vain: `good` does not come while the clock is in the
  /// interval.
  struct Wait {
    LocationId early = kNone; ///< before the interval; kNone if the interval starts at 0
    LocationId now = 0;       ///< within the interval; `first` returns this if there is no `early`
    /// After the interval: `lost` if nothing else is required; kNone if the interval is unbounded.
    LocationId late = kNone;
    [[nodiscard]] LocationId first() const { return early == kNone ? now : early; }
  };

  /// \param outside must hold during the whole wait
  /// \param good must not come within the interval
  Wait wait(NodeId good, const fiacre::Interval& when, LocationId lost, NodeId outside);
  /// The same within a part of a run: waiting also ends in vain at the part's end.
  Wait waitWithin(NodeId good, const fiacre::Interval& when, LocationId late, NodeId end,
                  LocationId lost);
  /// Starts a wait at a point where `when` holds.
  void begin(LocationId from, const Wait& wait, NodeId when, NodeId good, LocationId lost);

  const fiacre::Pattern& pattern;
  Nodes& nodes;
  Monitor made;
};

} // namespace proskill::verify
