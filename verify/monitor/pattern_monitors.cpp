#include "verify/monitor/pattern_monitors.h"

#include "verify/monitor/monitor_builder.h"

#include <utility>

namespace proskill::verify {

using fiacre::Interval;
using fiacre::Pattern;
using fiacre::PatternKind;

namespace {

constexpr Interval kAlways{};

/// Builds the monitor of a pattern; there is a function for each scope.
class PatternMonitor : MonitorBuilder {
public:
  PatternMonitor(const Pattern& of, Nodes& in,
                 const std::function<NodeId(const fiacre::Observable&)>& with)
      : MonitorBuilder(of, in), atom(with) {}

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
      const LocationId at = addLocation(yes(), true);
      go(at, addError(), a, withinInterval(*when));
      start(at);
      return true;
    }
    case PatternKind::LeadsTo: {
      const auto when = interval();
      if (!when) return false;
      const LocationId idle = addLocation(yes());
      start(idle);
      response(idle, a, *when);
      return true;
    }
    case PatternKind::Precedes: {
      if (!isUntimed()) return false;
      const LocationId none = addLocation(no(a));
      go(none, addError(), both(b, no(a)));
      start(none);
      return true;
    }
    case PatternKind::InfinitelyOften: {
      if (!isUntimed()) return false;
      const LocationId idle = addLocation(yes());
      const LocationId never = addLocation(no(a));
      made.locations[never].accepting = true;
      go(idle, never, no(a));
      start(idle);
      return true;
    }
    case PatternKind::Mortal: {
      if (!isUntimed()) return false;
      const LocationId idle = addLocation(yes());
      made.locations.push_back({.stay = yes(), .accepting = true});
      const auto again = static_cast<LocationId>(made.locations.size() - 1);
      go(idle, again, a);
      step(again, idle, yes());
      start(idle);
      return true;
    }
    case PatternKind::DeadlockFree:
    case PatternKind::Ltl:
    case PatternKind::Progress:
    case PatternKind::NoError:
    case PatternKind::AlwaysReachable:
    case PatternKind::Longest:
    case PatternKind::Shortest: return false;
    }
    std::unreachable();
  }

  /// After a point at which `when` is true, nothing good comes in time.
  void response(LocationId idle, NodeId when, const Interval& in) {
    const LocationId lost = addError();
    begin(idle, wait(b, in, lost, yes()), when, b, lost);
  }

  bool present() {
    const auto when = interval();
    if (!when) return false;
    start(wait(a, *when, addError(), yes()).first());
    return true;
  }

  /// Whether there are other times besides `lasting`.
  [[nodiscard]] bool isLonger() const {
    return pattern.within || pattern.forInterval || pattern.forDuration;
  }

  /// Locations that wait for a condition to last, and for it to end too early.
  struct Lasting {
    LocationId none;
    LocationId there;
  };

  Lasting lasting() {
    const LocationId none = addLocation(no(a));
    made.locations[none].accepting = true;
    const LocationId there = addLocation(yes(), true, lessThan(*pattern.lasting));
    go(none, there, a, {}, true);
    go(there, addError(), no(a), lessThan(*pattern.lasting));
    return {none, there};
  }

  bool lastingBehind(LocationId before, NodeId begun) {
    if (pattern.kind != PatternKind::Present || isLonger()) return false;
    const auto [none, there] = lasting();
    go(before, none, both(begun, no(a)));
    go(before, there, both(begun, a), {}, true);
    return true;
  }

  /// After the first point at which `after` is true.
  bool after() {
    const NodeId begun = atom(*pattern.after);
    const LocationId none = addLocation(no(begun));
    start(none);
    if (pattern.lasting) return lastingBehind(none, begun);
    const auto when = interval();
    if (!when) return false;
    switch (pattern.kind) {
    case PatternKind::Present: {
      const LocationId lost = addError();
      begin(none, wait(a, *when, lost, yes()), begun, a, lost);
      return true;
    }
    case PatternKind::Absent:
    case PatternKind::Always: {
      const LocationId since = addLocation(yes(), true);
      const LocationId lost = addError();
      go(none, since, begun, {}, true);
      go(since, lost, a, withinInterval(*when));
      if (hasZero(*when)) step(none, lost, both(begun, a));
      return true;
    }
    case PatternKind::LeadsTo: {
      const LocationId idle = addLocation(yes());
      go(none, idle, begun);
      const LocationId lost = addError();
      const Wait waits = wait(b, *when, lost, yes());
      begin(idle, waits, a, b, lost);
      begin(none, waits, both(begun, a), b, lost);
      return true;
    }
    case PatternKind::Precedes: {
      if (!isUntimed()) return false;
      const LocationId without = addLocation(no(a));
      const LocationId lost = addError();
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
    case PatternKind::NoError:
    case PatternKind::AlwaysReachable:
    case PatternKind::Longest:
    case PatternKind::Shortest: return false;
    }
    std::unreachable();
  }

  /// Before the first point at which `before` is true; if there is none, the property holds.
  bool before() {
    if (pattern.after) return false;
    const NodeId end = atom(*pattern.before);
    const NodeId open = no(end);
    const LocationId lost = addError();
    switch (pattern.kind) {
    case PatternKind::Present: {
      if (pattern.forDuration || pattern.lasting) return false;
      const auto when = interval().value_or(kAlways);
      const LocationId none = addLocation(both(open, no(a)));
      start(none);
      go(none, lost, end);
      if (isUntimed()) return true;
      const LocationId since = addLocation(open, true);
      go(none, since, both(open, a), {}, true);
      if (!hasZero(when)) go(since, lost, end, beforeInterval(when));
      if (when.upper) go(since, lost, end, afterInterval(when));
      return true;
    }
    case PatternKind::Absent:
    case PatternKind::Always: {
      const LocationId idle = addLocation(open);
      const LocationId since = addLocation(open, true);
      start(idle);
      go(idle, since, both(open, a), {}, true);
      if (pattern.lasting || (pattern.forDuration && (pattern.within || pattern.forInterval)))
        return false;
      const auto clock =
          pattern.forDuration ? lessThan(*pattern.forDuration) : withinInterval(*interval());
      go(since, lost, end, clock);
      return true;
    }
    case PatternKind::LeadsTo: {
      const auto when = interval();
      if (!when) return false;
      const LocationId idle = addLocation(open);
      const LocationId gone = addLocation(open); // too late; it counts when the end comes
      go(gone, lost, end);
      start(idle);
      begin(idle, waitWithin(b, *when, gone, end, lost), both(a, open), b, gone);
      return true;
    }
    case PatternKind::Precedes: {
      if (!isUntimed()) return false;
      const LocationId none = addLocation(both(open, no(a)));
      const LocationId wrong = addLocation(open);
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
    case PatternKind::NoError:
    case PatternKind::AlwaysReachable:
    case PatternKind::Longest:
    case PatternKind::Shortest: return false;
    }
    std::unreachable();
  }

  /// From each point at which `after` is true to the next at which `until` is.
  bool segments() {
    const auto when = interval();
    if (!when || pattern.before) return false;
    const NodeId end = atom(*pattern.until);
    const NodeId open = no(end);
    const NodeId begun = both(atom(*pattern.after), open);
    const LocationId idle = addLocation(yes());
    const LocationId lost = addError();
    start(idle);
    // a violation counts at once or, if the end is required, when it comes
    LocationId bad = lost;
    if (pattern.between) {
      bad = addLocation(open);
      go(bad, lost, end);
    }
    switch (pattern.kind) {
    case PatternKind::Absent:
    case PatternKind::Always: {
      const LocationId in = addLocation(open, true);
      go(idle, in, begun, {}, true);
      go(in, bad, both(open, a), withinInterval(*when));
      if (hasZero(*when)) step(idle, bad, both(begun, a));
      return true;
    }
    case PatternKind::Present: {
      const Wait waits = waitWithin(a, *when, bad, end, lost);
      begin(idle, waits, begun, a, bad);
      return true;
    }
    case PatternKind::LeadsTo: {
      const LocationId in = addLocation(open);
      go(idle, in, begun);
      const Wait waits = waitWithin(b, *when, bad, end, lost);
      begin(in, waits, both(open, a), b, bad);
      begin(idle, waits, both(begun, a), b, bad);
      return true;
    }
    case PatternKind::Precedes: {
      if (!isUntimed()) return false;
      const LocationId in = addLocation(both(open, no(a)));
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
    case PatternKind::NoError:
    case PatternKind::AlwaysReachable:
    case PatternKind::Longest:
    case PatternKind::Shortest: return false;
    }
    std::unreachable();
  }

  const std::function<NodeId(const fiacre::Observable&)>& atom;
  NodeId a = 0;
  NodeId b = 0;
};

} // namespace

std::optional<Monitor> monitorOf(const Pattern& pattern, Nodes& nodes,
                                 const std::function<NodeId(const fiacre::Observable&)>& atom) {
  return PatternMonitor(pattern, nodes, atom).write();
}

} // namespace proskill::verify
