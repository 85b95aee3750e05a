#include "tests/meaning/timed/pattern.h"

#include "tests/meaning/endless/fairness.h"

#include <algorithm>

namespace proskill::meaning {

using syntax::PropertyKind;

namespace {

constexpr std::size_t kLimit = 12'000; ///< situations, each with the value of the watch

/// A situation, or a step that leaves it: index of an edge.
struct Point {
  std::size_t node = 0;
  std::optional<std::size_t> edge;
  friend auto operator<=>(const Point&, const Point&) = default;
};

using Points = std::set<Point>;
using Predicate = std::function<bool(const Point&)>;

Predicate no(Predicate of) {
  return [of = std::move(of)](const Point& point) { return !of(point); };
}

Predicate both(Predicate x, Predicate y) {
  return [x = std::move(x), y = std::move(y)](const Point& point) { return x(point) && y(point); };
}

bool always(const Point& /*unused*/) { return true; }

/// Possible values of the watch, in units.
struct Times {
  std::int64_t lower = 0;
  std::optional<std::int64_t> upper;
  bool lowerOpen = false;
  bool upperOpen = false;
};

Times timesOf(const Script& script, const std::optional<syntax::Interval>& interval) {
  if (!interval) return {};
  Times times{.lower = script.units(interval->lower), .lowerOpen = interval->lowerOpen};
  if (interval->upper) times.upper = script.units(*interval->upper);
  times.upperOpen = interval->upperOpen;
  return times;
}

/// The points at which a pattern starts to count, and its condition from there on. Each `violates…`
/// says whether some run violates the pattern.
class Judge {
public:
  Judge(const syntax::Property& asked, const Script& of, const Runs& explored, const Seen& sees)
      : property(asked),
        script(of),
        runs(explored),
        seen(sees),
        times(timesOf(of, asked.within ? asked.within : asked.forDuration)) {
    wish = seeing(asked.operands[0]);
  }

  [[nodiscard]] std::optional<bool> isTrue() const {
    if (property.after && property.before) return std::nullopt;
    const bool timed = property.within || property.forDuration;
    if (property.lasting && (timed || property.before)) return std::nullopt;
    if (property.before) return !violatesBefore();
    return !violatesFrom(begin());
  }

private:
  [[nodiscard]] Predicate seeing(const syntax::Expr& condition) const {
    return [this, &condition](const Point& point) {
      const auto& node = runs.nodes()[point.node];
      static const std::vector<Fact> kNoFacts;
      return seen(condition, node.situation, point.edge ? node.edges[*point.edge].facts : kNoFacts);
    };
  }

  // --- The watch

  [[nodiscard]] const Age& age(const Point& point) const {
    return Runs::watch(runs.nodes()[point.node]);
  }
  [[nodiscard]] Predicate tooEarly(const Times& when) const {
    return [this, when](const Point& point) {
      return !reaches(age(point), when.lower, when.lowerOpen);
    };
  }
  [[nodiscard]] Predicate tooLate(const Times& when) const {
    return [this, when](const Point& point) {
      return when.upper && isPast(age(point), *when.upper, when.upperOpen);
    };
  }
  [[nodiscard]] Predicate inTime() const { return both(no(tooEarly(times)), no(tooLate(times))); }
  [[nodiscard]] Points restarted(const Points& points) const {
    Points made;
    for (const auto& point : points) made.insert({runs.nodes()[point.node].restarted, point.edge});
    return made;
  }

  // --- Paths

  /// The points with `goal` reached by a path on which all earlier points are `allowed`.
  [[nodiscard]] Points reached(const Points& from, const Predicate& allowed,
                               const Predicate& goal) const {
    Points known = from;
    std::vector<Point> todo(from.begin(), from.end());
    Points found;
    const auto visit = [&](const Point& point) {
      if (known.insert(point).second) todo.push_back(point);
    };
    while (!todo.empty()) {
      const Point point = todo.back();
      todo.pop_back();
      if (goal(point)) found.insert(point);
      if (!allowed(point)) continue;
      const auto& node = runs.nodes()[point.node];
      if (point.edge) {
        visit({node.edges[*point.edge].target, {}});
        continue;
      }
      for (std::size_t i = 0; i < node.edges.size(); ++i) visit({point.node, i});
      if (node.later) visit({*node.later, {}});
    }
    return found;
  }

  /// Whether a counted run goes on from one of these for ever with all points `allowed`.
  [[nodiscard]] bool canGoOn(const Points& from, const Predicate& allowed) const {
    std::vector<bool> nodes(runs.nodes().size());
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = allowed({i, {}});
    const auto mayPass = [&](std::size_t node, std::size_t edge) { return allowed({node, edge}); };
    const auto alive = goOn(countedBy(property), script, runs, nodes, mayPass);
    return std::ranges::any_of(from, [&](const Point& point) {
      if (!point.edge) return static_cast<bool>(alive[point.node]);
      return allowed(point) && alive[runs.nodes()[point.node].edges[*point.edge].target];
    });
  }

  // --- Patterns

  [[nodiscard]] Points starts() const {
    Points all;
    for (const auto node : runs.starts()) all.insert({node, {}});
    return all;
  }
  /// At the start, or where `after` is true for the first time.
  [[nodiscard]] Points begin() const {
    const Points start = starts();
    if (!property.after) return start;
    const auto after = seeing(*property.after);
    return restarted(reached(start, no(after), after));
  }

  /// Whether a run, with the watch at 0, does not reach `good` in time.
  [[nodiscard]] bool canMiss(const Points& from, const Predicate& good) const {
    const auto without = no(both(good, inTime()));
    if (!times.upper) return canGoOn(from, without);
    return !reached(from, without, both(without, tooLate(times))).empty();
  }

  [[nodiscard]] bool violatesFrom(const Points& from) const {
    switch (property.kind) {
    case PropertyKind::Absent: return !reached(from, always, both(wish, inTime())).empty();
    case PropertyKind::LeadsTo:
      return canMiss(restarted(reached(from, always, wish)), seeing(property.operands[1]));
    default: return property.lasting ? stopsTooSoon(from) : canMiss(from, wish);
    }
  }

  /// Whether it is never true, or not for long enough from the first time on.
  [[nodiscard]] bool stopsTooSoon(const Points& from) const {
    const auto soon = tooEarly({.lower = script.units(property.lasting->number)});
    const auto first = restarted(reached(from, no(wish), wish));
    return canGoOn(from, no(wish)) || !reached(first, soon, both(soon, no(wish))).empty();
  }

  /// The part before the first point with `before`, for runs that have one.
  [[nodiscard]] bool violatesBefore() const {
    const Points start = starts();
    const auto end = seeing(*property.before);
    const auto open = no(end);
    if (property.kind == PropertyKind::Absent) {
      const auto any = restarted(reached(start, open, both(open, wish)));
      return !reached(any, open, both(end, inTime())).empty();
    }
    const auto none = both(open, no(wish));
    if (!reached(start, none, end).empty()) return true;
    const auto first = restarted(reached(start, none, both(open, wish)));
    return !reached(first, open, both(end, no(inTime()))).empty();
  }

  const syntax::Property& property;
  const Script& script;
  const Runs& runs;
  const Seen& seen;
  Times times;
  Predicate wish;
};

std::int64_t longestOf(const syntax::Property& property, const Script& script) {
  std::int64_t longest = property.lasting ? script.units(property.lasting->number) : 0;
  for (const auto& interval : {property.within, property.forDuration}) {
    if (!interval) continue;
    longest = std::max(longest, script.units(interval->lower));
    if (interval->upper) longest = std::max(longest, script.units(*interval->upper));
  }
  return longest;
}

} // namespace

bool hasScopeOrTime(const syntax::Property& property) {
  return property.after || property.before || property.within || property.forDuration ||
         property.lasting;
}

std::optional<bool> isTrueInTime(const syntax::Property& property, const Script& script,
                                 const Seen& seen) {
  const Runs runs(script, kLimit, longestOf(property, script));
  if (!runs.complete()) return std::nullopt;
  return Judge(property, script, runs, seen).isTrue();
}

} // namespace proskill::meaning
