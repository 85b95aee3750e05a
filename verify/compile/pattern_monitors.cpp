#include "verify/compile/pattern_monitors.h"

#include "verify/state/timing.h"

#include <utility>

namespace proskill::verify {

using fiacre::Interval;
using fiacre::Pattern;
using fiacre::PatternKind;

namespace {

using Location = std::uint32_t;

constexpr Interval kAlways{};

bool hasZero(const Interval& interval) { return interval.lower == 0 && !interval.lowerOpen; }

ClockGuard within(const Interval& interval) { return {lowerBound(interval), upperBound(interval)}; }

/// Less than the interval's dates.
ClockGuard earlier(const Interval& interval) {
  return {kZero, bound(interval.lower, !interval.lowerOpen)};
}

/// As late as its dates, or later.
ClockGuard reached(const Interval& interval) { return {lowerBound(interval), kInfinite}; }

/// Later than its dates. \pre it has an end
ClockGuard later(const Interval& interval) {
  return {bound(-*interval.upper, !interval.upperOpen), kInfinite};
}

ClockGuard lessThan(std::int64_t time) { return {kZero, bound(time, true)}; }

/// Writes one monitor. `go` moves at a point where a condition holds, be it a state or a step; the
/// location that it moves to begins with that very point.
class Writer {
public:
  Writer(const Pattern& of, Nodes& in, const std::function<NodeId(const fiacre::Observable&)>& with)
      : pattern(of), nodes(in), atom(with) {}

  std::optional<Monitor> write() {
    const bool both = pattern.kind == PatternKind::LeadsTo || pattern.kind == PatternKind::Precedes;
    a = atom(pattern.operands.at(0));
    if (both) b = atom(pattern.operands.at(1));
    if (pattern.kind == PatternKind::Always) a = no(a);
    const bool known = pattern.until    ? segments()
                       : pattern.before ? before()
                       : pattern.after  ? after()
                                        : everywhere();
    if (!known) return std::nullopt;
    return std::move(made);
  }

private:
  [[nodiscard]] bool isUntimed() const {
    return !pattern.within && !pattern.forInterval && !pattern.forDuration && !pattern.lasting;
  }
  /// What `within` or `for interval` says, where that is all; else nothing.
  [[nodiscard]] std::optional<Interval> interval() const {
    if (pattern.forDuration || pattern.lasting || (pattern.within && pattern.forInterval))
      return std::nullopt;
    if (pattern.within) return pattern.within;
    return pattern.forInterval ? *pattern.forInterval : kAlways;
  }

  NodeId no(NodeId node) { return nodes.negation(node); }
  NodeId both(NodeId x, NodeId y) { return nodes.both(x, y); }
  NodeId yes() { return nodes.number(1); }

  /// A location in which every point fulfils `stay`.
  Location add(NodeId stay, bool timed = false, ClockGuard clock = {}) {
    const auto added = static_cast<Location>(made.locations.size());
    made.locations.push_back({.stay = stay, .timed = timed});
    step(added, added, stay, clock);
    return added;
  }
  Location addError() {
    made.locations.push_back({.stay = yes(), .error = true});
    return static_cast<Location>(made.locations.size() - 1);
  }
  void step(Location from, Location to, NodeId condition, ClockGuard clock = {},
            bool reset = false) {
    made.locations[from].edges.push_back({true, to, condition, clock, reset});
  }
  void silent(Location from, Location to, NodeId condition, ClockGuard clock = {},
              bool reset = false) {
    made.locations[from].edges.push_back({false, to, condition, clock, reset});
  }
  void go(Location from, Location to, NodeId condition, ClockGuard clock = {}, bool reset = false) {
    silent(from, to, condition, clock, reset);
    step(from, to, condition, clock, reset);
  }
  void start(Location at) { made.initial.push_back(at); }

  /// Where a run waits in vain: nothing good comes while the clock is in the interval.
  struct Wait {
    Location early = kNone; ///< before the interval; kNone where it begins at once
    Location now = 0;       ///< within it; `first` comes here where there is no `early`
    Location late = kNone;  ///< behind it, `lost` where nothing else is asked; kNone: unbounded
    [[nodiscard]] Location first() const { return early == kNone ? now : early; }
  };

  /// \param outside what holds all the time \param good what is not to come within the interval
  Wait wait(NodeId good, const Interval& when, Location lost, NodeId outside) {
    Wait wait;
    wait.now = add(both(outside, no(good)), when.upper.has_value());
    if (when.upper) {
      wait.late = lost;
      silent(wait.now, lost, yes(), verify::later(when));
    } else {
      made.locations[wait.now].accepting = true;
    }
    if (hasZero(when)) return wait;
    wait.early = add(outside, true, earlier(when));
    made.locations[wait.early].accepting = !when.upper; // time need not get there
    silent(wait.early, wait.now, no(good), reached(when));
    if (pattern.first) // too early is as bad as too late
      go(wait.early, lost, good, earlier(when));
    return wait;
  }

  /// Begins to wait at a point where `when` holds.
  void begin(Location from, const Wait& wait, NodeId when, NodeId good, Location lost) {
    const bool atOnce = wait.early == kNone;
    go(from, wait.first(), atOnce || pattern.first ? both(when, no(good)) : when, {}, true);
    if (!atOnce && pattern.first) go(from, lost, both(when, good));
  }

  bool everywhere() {
    switch (pattern.kind) {
    case PatternKind::Present:
      if (!pattern.lasting) return present();
      if (isLonger()) return false;
      start(lasting().none);
      return true;
    case PatternKind::Absent:
    case PatternKind::Always: {
      const auto when = interval();
      if (!when) return false;
      const Location at = add(yes(), true);
      go(at, addError(), a, within(*when));
      start(at);
      return true;
    }
    case PatternKind::LeadsTo: {
      const auto when = interval();
      if (!when) return false;
      const Location idle = add(yes());
      start(idle);
      response(idle, a, *when);
      return true;
    }
    case PatternKind::Precedes: {
      if (!isUntimed()) return false;
      const Location none = add(no(a));
      go(none, addError(), both(b, no(a)));
      start(none);
      return true;
    }
    case PatternKind::InfinitelyOften: {
      if (!isUntimed()) return false;
      const Location idle = add(yes());
      const Location never = add(no(a));
      made.locations[never].accepting = true;
      go(idle, never, no(a));
      start(idle);
      return true;
    }
    case PatternKind::Mortal: {
      if (!isUntimed()) return false;
      const Location idle = add(yes());
      made.locations.push_back({.stay = yes(), .accepting = true});
      const auto again = static_cast<Location>(made.locations.size() - 1);
      go(idle, again, a);
      step(again, idle, yes());
      start(idle);
      return true;
    }
    case PatternKind::DeadlockFree:
    case PatternKind::Ltl:
    case PatternKind::Progress:
    case PatternKind::NoError: return false;
    }
    std::unreachable();
  }

  /// From a point on where `when` holds, nothing good comes in time.
  void response(Location idle, NodeId when, const Interval& in) {
    const Location lost = addError();
    begin(idle, wait(b, in, lost, yes()), when, b, lost);
  }

  bool present() {
    const auto when = interval();
    if (!when) return false;
    start(wait(a, *when, addError(), yes()).first());
    return true;
  }

  /// Whether other times come with `lasting`.
  [[nodiscard]] bool isLonger() const {
    return pattern.within || pattern.forInterval || pattern.forDuration;
  }

  /// Waits for what has to last, and for it to end too early.
  struct Lasting {
    Location none;
    Location there;
  };

  Lasting lasting() {
    const Location none = add(no(a));
    made.locations[none].accepting = true;
    const Location there = add(yes(), true, lessThan(*pattern.lasting));
    go(none, there, a, {}, true);
    go(there, addError(), no(a), lessThan(*pattern.lasting));
    return {none, there};
  }

  bool lastingBehind(Location before, NodeId begun) {
    if (pattern.kind != PatternKind::Present || isLonger()) return false;
    const auto [none, there] = lasting();
    go(before, none, both(begun, no(a)));
    go(before, there, both(begun, a), {}, true);
    return true;
  }

  /// Behind the first point at which what `after` names is seen.
  bool after() {
    const NodeId begun = atom(*pattern.after);
    const Location none = add(no(begun));
    start(none);
    if (pattern.lasting) return lastingBehind(none, begun);
    const auto when = interval();
    if (!when) return false;
    switch (pattern.kind) {
    case PatternKind::Present: {
      const Location lost = addError();
      begin(none, wait(a, *when, lost, yes()), begun, a, lost);
      return true;
    }
    case PatternKind::Absent:
    case PatternKind::Always: {
      const Location since = add(yes(), true);
      const Location lost = addError();
      go(none, since, begun, {}, true);
      go(since, lost, a, within(*when));
      if (hasZero(*when)) step(none, lost, both(begun, a));
      return true;
    }
    case PatternKind::LeadsTo: {
      const Location idle = add(yes());
      go(none, idle, begun);
      const Location lost = addError();
      const Wait waits = wait(b, *when, lost, yes());
      begin(idle, waits, a, b, lost);
      begin(none, waits, both(begun, a), b, lost);
      return true;
    }
    case PatternKind::Precedes: {
      if (!isUntimed()) return false;
      const Location without = add(no(a));
      const Location lost = addError();
      go(none, without, both(begun, no(a)));
      go(without, lost, both(b, no(a)));
      step(none, lost, both(begun, both(b, no(a))));
      return true;
    }
    case PatternKind::DeadlockFree:
    case PatternKind::InfinitelyOften:
    case PatternKind::Mortal:
    case PatternKind::Ltl:
    case PatternKind::Progress:
    case PatternKind::NoError: return false;
    }
    std::unreachable();
  }

  /// Before the first point at which what `before` names is seen; where it never is, all is well.
  bool before() {
    if (pattern.after) return false;
    const NodeId end = atom(*pattern.before);
    const NodeId open = no(end);
    const Location lost = addError();
    switch (pattern.kind) {
    case PatternKind::Present: {
      if (pattern.forDuration || pattern.lasting) return false;
      const auto when = interval().value_or(kAlways);
      const Location none = add(both(open, no(a)));
      start(none);
      go(none, lost, end);
      if (isUntimed()) return true;
      const Location since = add(open, true);
      go(none, since, both(open, a), {}, true);
      if (!hasZero(when)) go(since, lost, end, earlier(when));
      if (when.upper) go(since, lost, end, verify::later(when));
      return true;
    }
    case PatternKind::Absent:
    case PatternKind::Always: {
      const Location idle = add(open);
      const Location since = add(open, true);
      start(idle);
      go(idle, since, both(open, a), {}, true);
      if (pattern.lasting || (pattern.forDuration && (pattern.within || pattern.forInterval)))
        return false;
      const auto clock = pattern.forDuration ? lessThan(*pattern.forDuration) : within(*interval());
      go(since, lost, end, clock);
      return true;
    }
    case PatternKind::LeadsTo: {
      const auto when = interval();
      if (!when) return false;
      const Location idle = add(open);
      const Location gone = add(open); // too late; it counts when the end comes
      go(gone, lost, end);
      start(idle);
      begin(idle, waitWithin(b, *when, gone, end, lost), both(a, open), b, gone);
      return true;
    }
    case PatternKind::Precedes: {
      if (!isUntimed()) return false;
      const Location none = add(both(open, no(a)));
      const Location wrong = add(open);
      start(none);
      go(none, wrong, both(open, both(b, no(a))));
      go(wrong, lost, end);
      return true;
    }
    case PatternKind::DeadlockFree:
    case PatternKind::InfinitelyOften:
    case PatternKind::Mortal:
    case PatternKind::Ltl:
    case PatternKind::Progress:
    case PatternKind::NoError: return false;
    }
    std::unreachable();
  }

  /// From each point where `after` is seen to the next where `until` is.
  bool segments() {
    const auto when = interval();
    if (!when || pattern.before) return false;
    const NodeId end = atom(*pattern.until);
    const NodeId open = no(end);
    const NodeId begun = both(atom(*pattern.after), open);
    const Location idle = add(yes());
    const Location lost = addError();
    start(idle);
    // A violation counts at once, or where the end has to come when it does.
    Location bad = lost;
    if (pattern.between) {
      bad = add(open);
      go(bad, lost, end);
    }
    switch (pattern.kind) {
    case PatternKind::Absent:
    case PatternKind::Always: {
      const Location in = add(open, true);
      go(idle, in, begun, {}, true);
      go(in, bad, both(open, a), within(*when));
      if (hasZero(*when)) step(idle, bad, both(begun, a));
      return true;
    }
    case PatternKind::Present: {
      const Wait waits = waitWithin(a, *when, bad, end, lost);
      begin(idle, waits, begun, a, bad);
      return true;
    }
    case PatternKind::LeadsTo: {
      const Location in = add(open);
      go(idle, in, begun);
      const Wait waits = waitWithin(b, *when, bad, end, lost);
      begin(in, waits, both(open, a), b, bad);
      begin(idle, waits, both(begun, a), b, bad);
      return true;
    }
    case PatternKind::Precedes: {
      if (!isUntimed()) return false;
      const Location in = add(both(open, no(a)));
      const NodeId wrong = both(open, both(b, no(a)));
      go(idle, in, both(begun, no(a)));
      go(in, bad, wrong);
      step(idle, bad, both(begun, wrong));
      return true;
    }
    case PatternKind::DeadlockFree:
    case PatternKind::InfinitelyOften:
    case PatternKind::Mortal:
    case PatternKind::Ltl:
    case PatternKind::Progress:
    case PatternKind::NoError: return false;
    }
    std::unreachable();
  }

  /// Waits in vain within a part of a run: up to its end, too.
  Wait waitWithin(NodeId good, const Interval& when, Location late, NodeId end, Location lost) {
    const Wait waits = wait(good, when, late, no(end));
    for (auto at : {waits.now, waits.first()}) {
      if (!pattern.until || pattern.between) made.locations[at].accepting = false; // it has to come
      go(at, lost, end);
      if (waits.early == kNone) break;
    }
    return waits;
  }

  const Pattern& pattern;
  Nodes& nodes;
  const std::function<NodeId(const fiacre::Observable&)>& atom;
  NodeId a = 0;
  NodeId b = 0;
  Monitor made;
};

} // namespace

std::optional<Monitor> monitorOf(const Pattern& pattern, Nodes& nodes,
                                 const std::function<NodeId(const fiacre::Observable&)>& atom) {
  return Writer(pattern, nodes, atom).write();
}

} // namespace proskill::verify
