#include "verify/trace/dates.h"

#include "verify/state/state_layout.h"
#include "verify/trace/clock_starts.h"
#include "verify/trace/monitor_stays.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// `later - earlier` is at most `limit`, or less: encoded as 2c + 1 or 2c, in 64 bits.
struct Constraint {
  std::size_t later = 0;
  std::size_t earlier = 0;
  std::int64_t limit = 1;
};

constexpr std::int64_t kNoLimit = INT64_MAX;

std::int64_t add(std::int64_t a, std::int64_t b) {
  if (a == kNoLimit || b == kNoLimit) return kNoLimit;
  return a + b - ((a | b) & 1);
}

/// Walks along the steps, and adds the constraints of each on dates. Date 0 is the start, date i
/// the i-th step, and the last date is that of the evidence.
class Writer {
public:
  Writer(const System& of, const Enabling& with, const Evidence& from, LimitWatch& watch)
      : system(of), enabling(with), evidence(from), limits(watch), stays(from) {}

  std::optional<std::vector<Constraint>> write() {
    std::vector<Word> state = initialState(system);
    enabling.compute(state.data(), enabled);
    for (std::size_t i = 0; i < evidence.steps.size(); ++i) {
      limits.check();
      limits.checkGrowth(all, 3 * system.transitions.size() + 2);
      const TransitionId step = evidence.steps[i];
      if (!contains(enabled, step)) return std::nullopt;
      letTimePass(i, i + 1);
      moveAtOnce(i, state.data());
      const auto& fired = system.transitions[step];
      if (fired.clock != kNone)
        all.push_back({since.of(fired.clock), i + 1, lowerBound(fired.interval)});
      for (auto blocker : fired.laterBlockers) {
        const auto& first = system.transitions[blocker];
        if (contains(enabled, blocker))
          all.push_back({i + 1, since.of(first.clock), notYet(first.interval)});
      }
      const TransitionSet before = enabled;
      const Outcome outcome = fire(system, step, state.data(), log);
      if (outcome == Outcome::Failed && i + 1 == evidence.steps.size()) {
        all.push_back({i + 1, i + 2, kZero}); // an error: the run ends here
        all.push_back({i + 2, i + 1, kZero});
        return std::move(all);
      }
      if (outcome != Outcome::Done) return std::nullopt;
      enabling.update(step, state.data(), enabled);
      since.restart(step, before, enabled, i + 1);
    }
    const std::size_t last = evidence.steps.size();
    letTimePass(last, last + 1);
    moveAtOnce(last, state.data());
    watch(last);
    for (const auto& range : evidence.clocks) {
      all.push_back({since.of(range.clock), last + 1, range.lower});
      if (range.upper != kInfinite) all.push_back({last + 1, since.of(range.clock), range.upper});
    }
    for (const auto& [a, b, limit] : evidence.differences) boundDifference(a, b, limit, last);
    return std::move(all);
  }

private:
  /// The age of a clock at the end is the date of the end less that of its start.
  void boundDifference(ClockId a, ClockId b, Bound limit, std::size_t last) {
    const std::size_t later = b == kNone ? last + 1 : since.of(b);
    const std::size_t earlier = a == kNone ? last + 1 : since.of(a);
    if (later != earlier) all.push_back({later, earlier, limit});
  }

  void letTimePass(std::size_t from, std::size_t to) {
    all.push_back({from, to, kZero});
    if (enabling.isUrgent(enabled)) all.push_back({to, from, kZero});
    eachIn(enabled, [&](TransitionId id) {
      const auto& transition = system.transitions[id];
      if (transition.clock != kNone && transition.interval.upper)
        all.push_back({to, since.of(transition.clock), upperBound(transition.interval)});
    });
  }

  /// A monitor leaves a location at once that does not allow the state.
  void moveAtOnce(std::size_t i, const Word* state) {
    stays.eachIn(i, [&](const MonitorStay& stay) {
      const auto allowed = evidence.monitor->locations[stay.location].stay;
      if (!holdsAt(system, allowed, {state, nullptr, nullptr}))
        all.push_back({stay.to, stay.from, kZero});
    });
  }

  /// Adds the moves of a monitor: their dates, and the value of its clock. Dates of their own come
  /// after that of the end.
  void watch(std::size_t last) {
    std::size_t reset = 0;
    std::size_t own = last + 2;
    std::size_t before = 0;
    std::optional<std::size_t> tick;
    for (const auto& mark : evidence.marks) {
      const std::size_t date = mark.atStep ? mark.after : own++;
      if (before != date) all.push_back({before, date, kZero}); // in this order
      if (mark.after != date) {
        all.push_back({mark.after, date, kZero});
        all.push_back({date, mark.until + 1, kZero});
      }
      before = date;
      if (mark.ticks) {
        if (tick) all.push_back({*tick, date, bound(-1, false)});
        tick = date;
        continue;
      }
      const auto& edge = evidence.monitor->locations[mark.location].edges[mark.edge];
      if (evidence.monitor->locations[mark.location].timed) {
        if (edge.clock.lower != kZero) all.push_back({reset, date, edge.clock.lower});
        if (edge.clock.upper != kInfinite) all.push_back({date, reset, edge.clock.upper});
      }
      if (edge.reset) reset = date;
    }
  }

  const System& system;
  const Enabling& enabling;
  const Evidence& evidence;
  LimitWatch& limits;
  MonitorStays stays;
  TransitionSet enabled;
  ClockStarts since{system};
  std::vector<Constraint> all;
  StepLog log;
};

/// Bellman-Ford: applies `relax` to all constraints until nothing changes. Constraints are in the
/// order of the steps, and most chains follow or reverse it. So the direction alternates, and a few
/// rounds suffice. \param values by date \return false if it does not terminate: mostly seen by the
/// value of date 0, which must not change
template <class Relax>
bool relaxAll(const std::vector<Constraint>& constraints, const std::vector<std::int64_t>& values,
              LimitWatch& limits, Relax relax) {
  const std::int64_t start = values[0];
  for (std::size_t round = 0; round <= values.size(); ++round) {
    limits.check();
    bool changed = false;
    if (round % 2 == 0)
      for (const auto& constraint : constraints) changed = relax(constraint) || changed;
    else
      for (std::size_t i = constraints.size(); i-- > 0;) changed = relax(constraints[i]) || changed;
    if (values[0] != start) return false;
    if (!changed) return true;
  }
  return false;
}

/// The tightest bound of each date relative to date 0, or of date 0 relative to each date.
std::optional<std::vector<std::int64_t>> tightest(const std::vector<Constraint>& constraints,
                                                  std::size_t dates, bool forward,
                                                  LimitWatch& limits) {
  std::vector<std::int64_t> bounds(dates, kNoLimit);
  bounds[0] = 1;
  const bool ends = relaxAll(constraints, bounds, limits, [&](const Constraint& constraint) {
    const std::size_t from = forward ? constraint.earlier : constraint.later;
    const std::size_t to = forward ? constraint.later : constraint.earlier;
    const std::int64_t limit = add(bounds[from], constraint.limit);
    if (limit >= bounds[to]) return false;
    bounds[to] = limit;
    return true;
  });
  return ends ? std::optional(std::move(bounds)) : std::nullopt;
}

/// The least dates that meet all constraints, in units so small that each strict bound can be
/// missed by one unit.
std::optional<std::vector<std::int64_t>> earliestRun(const std::vector<Constraint>& constraints,
                                                     std::size_t dates, std::int64_t scale,
                                                     LimitWatch& limits) {
  std::vector<std::int64_t> made(dates);
  const bool ends = relaxAll(constraints, made, limits, [&](const Constraint& constraint) {
    const auto& [later, earlier, limit] = constraint;
    const std::int64_t least = made[later] - ((limit >> 1) * scale - (limit % 2 == 0 ? 1 : 0));
    if (least <= made[earlier]) return false;
    made[earlier] = least;
    return true;
  });
  return ends ? std::optional(std::move(made)) : std::nullopt;
}

/// \return false if there are no such dates
bool addWindows(const std::vector<Constraint>& constraints, std::size_t dates, Dating& to,
                LimitWatch& limits) {
  const auto latest = tightest(constraints, dates, true, limits);
  const auto earliest = tightest(constraints, dates, false, limits);
  if (!latest || !earliest) return false;
  for (std::size_t i = 1; i <= to.steps.size(); ++i) {
    Window& window = to.steps[i - 1];
    window.earliest = {-((*earliest)[i] >> 1), (*earliest)[i] % 2 == 0};
    if ((*latest)[i] != kNoLimit) window.latest = Date{(*latest)[i] >> 1, (*latest)[i] % 2 == 0};
  }
  return true;
}

} // namespace

std::optional<Dating> dated(const System& system, const Enabling& enabling,
                            const Evidence& evidence, LimitWatch& limits, bool windows) {
  auto constraints = Writer(system, enabling, evidence, limits).write();
  if (!constraints) return std::nullopt;
  const auto ofTheMonitor = static_cast<std::size_t>(
      std::ranges::count(evidence.marks, false, &MonitorMove::atStep)); // moves between steps
  const std::size_t dates = evidence.steps.size() + 2 + ofTheMonitor;
  bool strict = std::ranges::any_of(*constraints, [](const auto& c) { return c.limit % 2 == 0; });
  Dating made{.scale = strict ? static_cast<std::int64_t>(dates) : 1};
  auto run = earliestRun(*constraints, dates, made.scale, limits);
  if (!run) return std::nullopt;
  for (std::size_t i = 1; i <= evidence.steps.size(); ++i)
    made.steps.push_back({.date = (*run)[i]});
  if (windows && !addWindows(*constraints, dates, made, limits)) return std::nullopt;
  made.end = (*run)[evidence.steps.size() + 1];
  for (std::size_t i = evidence.steps.size() + 2; i < dates; ++i) made.marks.push_back((*run)[i]);
  return made;
}

} // namespace proskill::verify
