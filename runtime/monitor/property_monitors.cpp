#include "runtime/monitor/property_monitors.h"

#include <algorithm>

namespace proskill::runtime {

using verify::Goal;
using verify::GoalKind;
using verify::Word;

namespace {

template <class... Cases> struct Match : Cases... { using Cases::operator()...; };

Verdict opposite(Verdict verdict) {
  switch (verdict) {
  case Verdict::NotYet: return Verdict::NotYet;
  case Verdict::True: return Verdict::False;
  case Verdict::False: return Verdict::True;
  }
  return Verdict::NotYet;
}

} // namespace

PropertyMonitors::PropertyMonitors(const verify::System& of, const std::vector<Monitored>& all,
                                   Nanoseconds unit)
    : system(of), properties(all) {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    decisions.push_back({i, Verdict::NotYet, 0});
    if (whyNotMonitored(properties[i]).empty()) add(i, properties[i], unit);
  }
}

void PropertyMonitors::add(std::size_t property, const Monitored& of, Nanoseconds unit) {
  if (of.goal.kind != GoalKind::Run)
    open.push_back({property, Reach{&of.goal, {}}});
  else if (of.negated)
    open.push_back({property, Formula{FormulaMonitor(system, of.negated->monitor),
                                      FormulaMonitor(system, of.goal.monitor)}});
  else
    open.push_back({property, PatternMonitor(system, of.goal.monitor, unit)});
}

template <class Move> void PropertyMonitors::eachOpen(Move&& move, const Decided& decided) {
  std::erase_if(open, [&](Watch& watch) {
    const Decision made = move(watch);
    if (made.verdict == Verdict::NotYet) return false;
    decisions[made.property] = made;
    decided(made);
    return true;
  });
  deadline = kUnknown;
}

void PropertyMonitors::start(const Word* state, const Decided& decided) {
  eachOpen([&](Watch& watch) { return begin(watch, state); }, decided);
}

void PropertyMonitors::step(const Taken& step, const Decided& decided) {
  for (const auto event : step.events) events.insert(event);
  eachOpen([&](Watch& watch) { return take(watch, step); }, decided);
  for (const auto event : step.events) events.erase(event);
}

void PropertyMonitors::wait(const Word* state, Nanoseconds until, const Decided& decided) {
  if (nextDecision(state).value_or(until + 1) > until) return;
  eachOpen([&](Watch& watch) { return stay(watch, state, until); }, decided);
}

PropertyMonitors::Decision PropertyMonitors::begin(Watch& watch, const Word* state) {
  std::visit(Match{[&](Reach& reach) {
                     const bool isThere =
                         reach.goal->kind == GoalKind::Events
                             ? reach.goal->initially
                             : holdsAt(system, reach.goal->condition, {state, nullptr, nullptr});
                     if (isThere) reach.found = 0;
                   },
                   [&](PatternMonitor& pattern) { pattern.start(state); },
                   [&](Formula& formula) {
                     formula.itself.start(state);
                     formula.negation.start(state);
                   }},
             watch.monitor);
  return decisionOf(watch, 0);
}

PropertyMonitors::Decision PropertyMonitors::take(Watch& watch, const Taken& step) {
  const verify::Moment moment{step.before, step.after, &events};
  std::visit(Match{[&](Reach& reach) {
                     if (isReached(*reach.goal, step)) reach.found = step.date;
                   },
                   [&](PatternMonitor& pattern) {
                     pattern.wait(step.before, step.date);
                     pattern.step(moment);
                   },
                   [&](Formula& formula) {
                     if (step.asksToStop) return;
                     formula.itself.step(moment);
                     formula.negation.step(moment);
                   }},
             watch.monitor);
  return decisionOf(watch, step.date);
}

bool PropertyMonitors::isReached(const Goal& goal, const Taken& step) const {
  if (goal.kind == GoalKind::Events) return events.meets(goal.events);
  return holdsAt(system, goal.condition, {step.after, nullptr, nullptr}) ||
         (goal.ofSteps && holdsAt(system, goal.condition, {step.before, step.after, &events}));
}

PropertyMonitors::Decision PropertyMonitors::stay(Watch& watch, const Word* state,
                                                  Nanoseconds until) {
  if (auto* pattern = std::get_if<PatternMonitor>(&watch.monitor)) pattern->wait(state, until);
  return decisionOf(watch, until);
}

PropertyMonitors::Decision PropertyMonitors::decisionOf(const Watch& watch,
                                                        Nanoseconds date) const {
  Decision made{watch.property, Verdict::NotYet, date};
  std::visit(Match{[&](const Reach& reach) {
                     if (reach.found) made.verdict = Verdict::False;
                   },
                   [&](const PatternMonitor& pattern) {
                     if (pattern.cannotBeViolated()) made.verdict = Verdict::True;
                     if (!pattern.violated()) return;
                     made.verdict = Verdict::False;
                     made.date = *pattern.violated();
                   },
                   [&](const Formula& formula) {
                     if (formula.negation.isDead()) made.verdict = Verdict::True;
                     if (formula.itself.isDead()) made.verdict = Verdict::False;
                   }},
             watch.monitor);
  if (properties[watch.property].isGood) made.verdict = opposite(made.verdict);
  return made;
}

std::optional<Nanoseconds> PropertyMonitors::nextDecision(const Word* state) {
  constexpr Nanoseconds kNoDate = INT64_MAX;
  if (deadline == kUnknown) {
    deadline = kNoDate;
    for (const auto& watch : open)
      if (const auto* pattern = std::get_if<PatternMonitor>(&watch.monitor))
        deadline = std::min(deadline, pattern->nextDecision(state).value_or(kNoDate));
  }
  return deadline == kNoDate ? std::nullopt : std::optional(deadline);
}

} // namespace proskill::runtime
