#include "tests/support/oracle/point_judge.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace proskill::oracle {

using fiacre::Interval;
using fiacre::Observable;
using fiacre::Pattern;
using fiacre::PatternKind;

namespace {

/// A node, or a step that leaves it.
struct Point {
  std::size_t node = 0;
  std::optional<std::size_t> edge;
  friend auto operator<=>(const Point&, const Point&) = default;
};

using Points = std::set<Point>;
using Predicate = std::function<bool(const Point&)>;

class PointJudge {
public:
  PointJudge(const Interpreter& of, const RegionGraph& in, const Pattern& asked)
      : model(of), graph(in), pattern(asked) {}

  std::optional<bool> judge() {
    a = seeing(pattern.operands.at(0));
    if (pattern.operands.size() > 1) b = seeing(pattern.operands[1]);
    if (pattern.kind == PatternKind::Always) a = negation(a);
    auto violated = pattern.until ? parts() : pattern.before ? before() : from(begin());
    if (!violated) return std::nullopt;
    return !*violated;
  }

private:
  [[nodiscard]] Predicate seeing(const Observable& observable) const {
    return [this, observable](const Point& point) {
      const Node& node = graph.nodes()[point.node];
      const DiscreteState& state = graph.discrete(node.discrete);
      const Firing* firing = point.edge ? &state.firings[node.edges[*point.edge].firing] : nullptr;
      return observed(model, observable, {&state.store, firing});
    };
  }
  static Predicate negation(const Predicate& of) {
    return [of](const Point& point) { return !of(point); };
  }
  static Predicate both(const Predicate& x, const Predicate& y) {
    return [x, y](const Point& point) { return x(point) && y(point); };
  }
  static Predicate anything() {
    return [](const Point&) { return true; };
  }

  [[nodiscard]] const Age& age(const Point& point) const {
    const auto& region = graph.nodes()[point.node].region;
    return *std::ranges::find(region, kWatch, &Age::clock);
  }
  [[nodiscard]] bool early(const Point& point, const Interval& when) const {
    const Age& watch = age(point);
    if (watch.beyond || watch.whole > when.lower) return false;
    return watch.whole < when.lower || (watch.rank == 0 && when.lowerOpen);
  }
  [[nodiscard]] bool late(const Point& point, const Interval& when) const {
    if (!when.upper) return false;
    const Age& watch = age(point);
    if (watch.beyond || watch.whole > *when.upper) return true;
    return watch.whole == *when.upper && (watch.rank > 0 || when.upperOpen);
  }
  [[nodiscard]] Predicate during(const Interval& when) const {
    return [this, when](const Point& point) { return !early(point, when) && !late(point, when); };
  }
  [[nodiscard]] Predicate behind(const Interval& when) const {
    return [this, when](const Point& point) { return late(point, when); };
  }
  [[nodiscard]] Predicate ahead(const Interval& when) const {
    return [this, when](const Point& point) { return early(point, when); };
  }

  /// The same points with the watch at 0.
  [[nodiscard]] Points restarted(const Points& points) const {
    Points made;
    for (const auto& point : points) made.insert({graph.nodes()[point.node].restarted, point.edge});
    return made;
  }

  [[nodiscard]] std::vector<Point> next(const Point& point) const {
    const Node& node = graph.nodes()[point.node];
    if (point.edge) return {{node.edges[*point.edge].target, {}}};
    std::vector<Point> all;
    for (std::size_t i = 0; i < node.edges.size(); ++i) all.push_back({point.node, i});
    if (node.later) all.push_back({*node.later, {}});
    return all;
  }

  /// The points with `goal` reached through points with `allowed` only.
  [[nodiscard]] Points until(const Points& start, const Predicate& allowed,
                             const Predicate& goal) const {
    Points seen = start;
    std::vector<Point> todo(start.begin(), start.end());
    Points found;
    while (!todo.empty()) {
      const Point point = todo.back();
      todo.pop_back();
      if (goal(point)) found.insert(point);
      if (!allowed(point)) continue;
      for (const auto& each : next(point))
        if (seen.insert(each).second) todo.push_back(each);
    }
    return found;
  }

  /// Whether a run stays among points with `allowed` to its end, or for ever. Removes points that
  /// cannot.
  [[nodiscard]] bool canStay(const Points& start, const Predicate& allowed) const {
    Points alive;
    for (std::size_t node = 0; node < graph.nodes().size(); ++node) {
      if (allowed({node, {}})) alive.insert({node, {}});
      for (std::size_t i = 0; i < graph.nodes()[node].edges.size(); ++i)
        if (allowed({node, i})) alive.insert({node, i});
    }
    // there must be steps: time alone is not a run
    for (bool changed = true; changed;) {
      changed = false;
      Points fed; // from which a remaining step or the end can be reached by waiting
      std::vector<Point> todo;
      std::map<std::size_t, std::vector<std::size_t>> earlier;
      for (const auto& point : alive) {
        if (point.edge) continue;
        const Node& node = graph.nodes()[point.node];
        if (node.later) earlier[*node.later].push_back(point.node);
        // in a last state time passes for ever, if it can
        bool feeds = graph.discrete(node.discrete).firings.empty() &&
                     (!node.later || alive.contains({*node.later, {}}));
        for (std::size_t i = 0; i < node.edges.size(); ++i)
          feeds = feeds || alive.contains({point.node, i});
        if (feeds && fed.insert(point).second) todo.push_back(point);
      }
      while (!todo.empty()) {
        const Point point = todo.back();
        todo.pop_back();
        for (auto source : earlier[point.node])
          if (fed.insert({source, {}}).second) todo.push_back({source, {}});
      }
      std::erase_if(alive, [&](const Point& point) {
        const bool dead =
            point.edge ? !alive.contains({graph.nodes()[point.node].edges[*point.edge].target, {}})
                       : !fed.contains(point);
        changed = changed || dead;
        return dead;
      });
    }
    return std::ranges::any_of(start, [&](const Point& point) { return alive.contains(point); });
  }

  /// Whether a step leads to one of the points, at once or after a delay: time alone is not a run.
  [[nodiscard]] bool stepsInto(const Point& from, const Points& points) const {
    const auto leads = [&](std::size_t node, std::size_t edge) {
      return points.contains({graph.nodes()[node].edges[edge].target, {}});
    };
    if (from.edge) return leads(from.node, *from.edge);
    std::set<std::size_t> passed;
    for (std::optional<std::size_t> at = from.node; at && passed.insert(*at).second;
         at = graph.nodes()[*at].later)
      for (std::size_t i = 0; i < graph.nodes()[*at].edges.size(); ++i)
        if (leads(*at, i)) return true;
    return false;
  }

  /// Whether a run reaches `wanted` infinitely often: at its end, or on a cycle with a step.
  /// Removes points that cannot reach `wanted` again until nothing changes.
  [[nodiscard]] bool canRepeat(const Predicate& wanted) const {
    Points alive = until({{0, {}}}, anything(), anything());
    const auto rests = [&](const Point& point) {
      return !point.edge && wanted(point) &&
             graph.discrete(graph.nodes()[point.node].discrete).firings.empty();
    };
    for (bool changed = true; changed;) {
      const auto recurs = [&](const Point& point) {
        return rests(point) || (wanted(point) && stepsInto(point, alive));
      };
      std::map<Point, std::vector<Point>> before;
      std::vector<Point> todo;
      Points fed;
      for (const auto& point : alive) {
        for (const auto& each : next(point)) before[each].push_back(point);
        if (recurs(point)) todo.push_back(point);
      }
      fed.insert(todo.begin(), todo.end());
      while (!todo.empty()) {
        const Point point = todo.back();
        todo.pop_back();
        for (const auto& source : before[point])
          if (alive.contains(source) && fed.insert(source).second) todo.push_back(source);
      }
      changed = fed.size() != alive.size();
      alive = std::move(fed);
    }
    return alive.contains({0, {}});
  }

  [[nodiscard]] std::optional<Interval> times() const {
    if (pattern.forDuration || pattern.lasting) return std::nullopt;
    return pattern.within ? *pattern.within : pattern.forInterval.value_or(Interval{});
  }

  /// The points at which the pattern starts to count, with the watch at 0.
  [[nodiscard]] Points begin() const {
    if (!pattern.after) return {{0, {}}};
    const auto after = seeing(*pattern.after);
    return restarted(until({{0, {}}}, negation(after), after));
  }

  /// Whether a run from these points, at which the watch is at 0, does not reach `good` in time.
  [[nodiscard]] bool missed(const Points& start, const Predicate& good,
                            const Interval& when) const {
    const auto allowed = negation(both(good, during(when)));
    if (when.upper) return !until(start, allowed, both(allowed, behind(when))).empty();
    return canStay(start, allowed);
  }

  [[nodiscard]] std::optional<bool> from(const Points& start) const {
    const auto when = times();
    switch (pattern.kind) {
    case PatternKind::Present:
      if (pattern.lasting) {
        const Interval least{.lower = *pattern.lasting};
        const auto first = restarted(until(start, negation(a), a));
        return canStay(start, negation(a)) ||
               !until(first, ahead(least), both(ahead(least), negation(a))).empty();
      }
      return when ? std::optional(missed(start, a, *when)) : std::nullopt;
    case PatternKind::Absent:
    case PatternKind::Always:
      if (!when) return std::nullopt;
      return !until(start, anything(), both(a, during(*when))).empty();
    case PatternKind::LeadsTo: {
      if (!when) return std::nullopt;
      const auto asked = restarted(until(start, anything(), a));
      if (!pattern.first) return missed(asked, b, *when);
      const bool tooEarly = !until(asked, negation(b), both(b, ahead(*when))).empty();
      return tooEarly || missed(asked, b, *when);
    }
    case PatternKind::Precedes: return !until(start, negation(a), both(b, negation(a))).empty();
    case PatternKind::InfinitelyOften:
      return canStay(until(start, anything(), negation(a)), negation(a));
    case PatternKind::Mortal: return canRepeat(a);
    default: return std::nullopt;
    }
  }

  [[nodiscard]] std::optional<bool> before() const {
    if (pattern.after || pattern.lasting) return std::nullopt;
    const auto end = seeing(*pattern.before);
    const auto open = negation(end);
    const Points start{{0, {}}};
    const Interval when = times().value_or(Interval{});
    switch (pattern.kind) {
    case PatternKind::Present: {
      const auto none = both(open, negation(a));
      if (!until(start, none, end).empty()) return true;
      const auto first = restarted(until(start, none, both(open, a)));
      return !until(first, open, both(end, negation(during(when)))).empty();
    }
    case PatternKind::Absent:
    case PatternKind::Always: {
      const auto seen = restarted(until(start, open, both(open, a)));
      const Interval duration{.lower = pattern.forDuration.value_or(0)};
      return !until(seen, open, both(end, pattern.forDuration ? ahead(duration) : during(when)))
                  .empty();
    }
    case PatternKind::Precedes: {
      const auto wrong = until(start, both(open, negation(a)), both(open, both(b, negation(a))));
      return !until(wrong, open, end).empty();
    }
    case PatternKind::LeadsTo: {
      if (pattern.first) return std::nullopt;
      const auto asked = restarted(until(start, open, both(open, a)));
      const auto inTime = both(open, both(b, during(when)));
      return !until(asked, both(open, negation(inTime)), end).empty();
    }
    default: return std::nullopt;
    }
  }

  /// Whether points within a part count: if its end is required, only if it comes.
  [[nodiscard]] bool counts(const Points& points, const Predicate& end) const {
    return !(pattern.between ? until(points, negation(end), end) : points).empty();
  }

  /// Whether a part may pass without `wanted`, from these points on.
  [[nodiscard]] bool lacks(const Points& start, const Predicate& good, const Interval& when,
                           const Predicate& end) const {
    const auto allowed = both(negation(end), negation(both(good, during(when))));
    if (!until(start, allowed, end).empty()) return true;
    if (pattern.between) return false;
    if (when.upper) return !until(start, allowed, both(allowed, behind(when))).empty();
    return canStay(start, allowed);
  }

  /// From each point with `after` to the next one with `until`.
  [[nodiscard]] std::optional<bool> parts() const {
    const auto when = times();
    if (!when || pattern.before) return std::nullopt;
    const auto end = seeing(*pattern.until);
    const auto open = negation(end);
    const auto begun = both(seeing(*pattern.after), open);
    const auto start = restarted(until({{0, {}}}, anything(), begun));
    switch (pattern.kind) {
    case PatternKind::Absent:
    case PatternKind::Always:
      return counts(until(start, open, both(open, both(a, during(*when)))), end);
    case PatternKind::Present: return lacks(start, a, *when, end);
    case PatternKind::LeadsTo: {
      const auto asked = restarted(until(start, open, both(open, a)));
      const auto tooEarly =
          until(asked, both(open, negation(b)), both(open, both(b, ahead(*when))));
      return (pattern.first && counts(tooEarly, end)) || lacks(asked, b, *when, end);
    }
    case PatternKind::Precedes:
      return counts(until(start, both(open, negation(a)), both(open, both(b, negation(a)))), end);
    default: return std::nullopt;
    }
  }

  const Interpreter& model;
  const RegionGraph& graph;
  const Pattern& pattern;
  Predicate a;
  Predicate b;
};

} // namespace

std::optional<bool> isTrueOfPoints(const Interpreter& model, const RegionGraph& graph,
                                   const Pattern& pattern) {
  return PointJudge(model, graph, pattern).judge();
}

} // namespace proskill::oracle
