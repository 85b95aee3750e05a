#include "tests/oracle/replay.h"

#include <algorithm>

namespace proskill::oracle {

using fiacre::Interval;
using fiacre::ObservableKind;
using fiacre::PatternKind;
using verify::Step;

namespace {

/// A discrete state with the exact age of each transition, in the trace's unit.
struct Concrete {
  Store store;
  std::map<ClockId, std::int64_t> ages;
  friend auto operator<=>(const Concrete&, const Concrete&) = default;
};

class Replay {
public:
  Replay(const Interpreter& of, const fiacre::Provenance& origins, const verify::Trace& path)
      : model(of), provenance(origins), trace(path) {}

  std::optional<std::string> run(const fiacre::Pattern& pattern) {
    now = {fresh(model.initial())};
    shown = seen(pattern, {&model.initial(), nullptr});
    std::int64_t date = 0;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      const Step& step = trace.steps[i];
      if (step.date < date) return say(i, "goes back in time");
      if (!letPass(step.date - date)) return say(i, "time cannot pass until its date");
      date = step.date;
      if (!take(step, pattern)) return say(i, "no such step");
      if (!inWindow(step)) return say(i, "a date outside its own window");
    }
    if (!shown && !endsBadly(pattern))
      return "the end does not show what the trace is a witness of";
    return std::nullopt;
  }

private:
  static std::string say(std::size_t step, const std::string& what) {
    return "step " + std::to_string(step + 1) + ": " + what;
  }

  Concrete fresh(const Store& store) const {
    Concrete state{store, {}};
    for (const auto& firing : model.firings(store)) state.ages[firing.clock] = 0;
    return state;
  }

  bool letPass(std::int64_t delay) {
    std::set<Concrete> later;
    for (Concrete state : now) {
      bool allowed = std::ranges::all_of(model.firings(state.store), [&](const Firing& firing) {
        const Interval& window = firing.interval;
        std::int64_t age = state.ages.at(firing.clock) + delay;
        std::int64_t upper = window.upper.value_or(0) * trace.scale;
        return delay == 0 || !window.upper || age < upper || (age == upper && !window.upperOpen);
      });
      if (!allowed) continue;
      for (auto& [_, age] : state.ages) age += delay;
      later.insert(std::move(state));
    }
    now = std::move(later);
    return !now.empty();
  }

  bool take(const Step& step, const fiacre::Pattern& pattern) {
    std::set<Concrete> next;
    bool showing = false;
    for (const auto& state : now)
      for (const auto& firing : model.firings(state.store)) {
        std::int64_t lower = firing.interval.lower * trace.scale;
        std::int64_t age = state.ages.at(firing.clock);
        bool ripe = age > lower || (age == lower && !firing.interval.lowerOpen);
        ripe = ripe && std::ranges::none_of(model.firings(state.store), [&](const Firing& other) {
                 const std::int64_t its = state.ages.at(other.clock);
                 const std::int64_t from = other.interval.lower * trace.scale;
                 return model.goesBefore(other, firing) &&
                        (its > from || (its == from && !other.interval.lowerOpen));
               });
        if (!ripe || !looksLike(step, state.store, firing)) continue;
        showing = showing || seen(pattern, {&state.store, &firing}) ||
                  seen(pattern, {&firing.after, nullptr});
        next.insert(after(state, firing));
      }
    now = std::move(next);
    shown = showing;
    return !now.empty();
  }

  Concrete after(const Concrete& state, const Firing& firing) const {
    Concrete next = fresh(firing.after);
    for (auto& [clock, age] : next.ages) {
      auto old = state.ages.find(clock);
      bool moved = std::ranges::any_of(model.participants(clock), [&](std::size_t instance) {
        return std::ranges::find(firing.movers, instance) != firing.movers.end();
      });
      if (old != state.ages.end() && !moved && clock != firing.clock) age = old->second;
    }
    return next;
  }

  bool looksLike(const Step& step, const Store& before, const Firing& firing) const {
    bool origins = std::ranges::all_of(step.origins, [&](fiacre::OriginId origin) {
      return std::ranges::find(firing.origins, origin) != firing.origins.end();
    });
    return origins && movesTheSame(step, firing) && changesTheSame(step, before, firing.after);
  }

  /// The names of transitions, such as `skill_takeoff_1_t3`, contain the instances.
  bool movesTheSame(const Step& step, const Firing& firing) const {
    std::string all;
    for (const auto& name : step.transitions) all += "_" + name;
    return std::ranges::all_of(firing.participants, [&](std::size_t instance) {
      return all.find("_" + instanceName(instance) + "_t") != std::string::npos;
    });
  }

  /// The process and the number of its instance, from 1.
  std::string instanceName(std::size_t instance) const {
    const auto* process = model.instances()[instance].process;
    auto end = model.instances().begin() + static_cast<std::ptrdiff_t>(instance) + 1;
    auto which = std::count_if(model.instances().begin(), end,
                               [&](const Instance& other) { return other.process == process; });
    return process->name + "_" + std::to_string(which);
  }

  bool changesTheSame(const Step& step, const Store& before, const Store& after) const {
    return std::ranges::all_of(provenance.watched, [&](const fiacre::Watched& watched) {
      bool told = std::ranges::find(step.changes, watched.display, &verify::Change::variable) !=
                  step.changes.end();
      return told == (model.show(watched.lvalue, before) != model.show(watched.lvalue, after));
    });
  }

  bool inWindow(const Step& step) const {
    std::int64_t earliest = step.earliest.value * trace.scale;
    if (step.date < earliest || (step.earliest.strict && step.date == earliest)) return false;
    if (!step.latest) return true;
    std::int64_t latest = step.latest->value * trace.scale;
    return step.date < latest || (!step.latest->strict && step.date == latest);
  }

  bool seen(const fiacre::Pattern& pattern, Moment moment) const {
    if (pattern.kind == PatternKind::Absent) return observed(model, pattern.operands[0], moment);
    return pattern.kind == PatternKind::Always && !observed(model, pattern.operands[0], moment);
  }

  /// What the last state shows, and not a step.
  bool endsBadly(const fiacre::Pattern& pattern) const {
    // the region graph decides these
    if (pattern.kind == PatternKind::Progress) return true;
    if (pattern.kind == PatternKind::AlwaysReachable)
      return std::ranges::any_of(now, [&](const Concrete& state) {
        return !observed(model, pattern.operands[0], {&state.store, nullptr});
      });
    return pattern.kind == PatternKind::DeadlockFree &&
           std::ranges::any_of(now, [&](const Concrete& state) {
             return model.firings(state.store).empty() &&
                    std::ranges::none_of(pattern.operands, [&](const auto& excluded) {
                      return observed(model, excluded, {&state.store, nullptr});
                    });
           });
  }

  const Interpreter& model;
  const fiacre::Provenance& provenance;
  const verify::Trace& trace;
  std::set<Concrete> now;
  bool shown = false; ///< the property's witness, at the last moment
};

} // namespace

std::optional<std::string> replay(const Interpreter& model, const fiacre::Provenance& provenance,
                                  const fiacre::Pattern& pattern, const verify::Trace& trace) {
  return Replay(model, provenance, trace).run(pattern);
}

} // namespace proskill::oracle
