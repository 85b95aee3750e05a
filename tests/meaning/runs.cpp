#include "tests/meaning/runs.h"

#include <algorithm>

namespace proskill::meaning {

bool reaches(const Age& age, std::int64_t bound, bool open) {
  if (age.beyond || age.whole > bound) return true;
  return age.whole == bound && (!open || age.fraction > 0);
}

bool isPast(const Age& age, std::int64_t bound, bool open) { return reaches(age, bound, !open); }

namespace {

/// Whether the step is due now.
bool hasToHappen(const Step& step, const std::vector<Age>& ages) {
  const auto& when = step.when;
  if (when.isUrgent()) return true;
  return when.clock != kNobody && when.upper && !when.upperOpen &&
         reaches(ages[when.clock], *when.upper, false);
}

/// Clocks at integers get a fraction; otherwise the greatest fraction becomes an integer.
std::vector<Age> later(std::vector<Age> ages) {
  const bool someWhole = std::ranges::any_of(
      ages, [](const Age& age) { return age.counts && !age.beyond && age.fraction == 0; });
  std::int64_t greatest = 0;
  for (const auto& age : ages) greatest = std::max(greatest, age.fraction);
  for (auto& age : ages) {
    if (!age.counts || age.beyond) continue;
    if (someWhole)
      ++age.fraction;
    else if (age.fraction == greatest)
      age = {.counts = true, .whole = age.whole + 1};
  }
  return ages;
}

} // namespace

bool isLate(const When& when, const std::vector<Age>& ages) {
  return when.clock != kNobody && when.upper &&
         isPast(ages[when.clock], *when.upper, when.upperOpen);
}

bool isDue(const When& when, const std::vector<Age>& ages) {
  if (when.clock == kNobody) return true;
  const auto& age = ages[when.clock];
  return reaches(age, when.lower, when.lowerOpen) &&
         (!when.upper || !isPast(age, *when.upper, when.upperOpen));
}

Runs::Runs(const Script& of, std::size_t limit, std::optional<std::int64_t> watch)
    : script(of), longest(watch.value_or(0)), hasWatch(watch.has_value()) {
  const auto note = [&](const syntax::Interval& interval) {
    longest = std::max(longest, script.units(interval.lower));
    if (interval.upper) longest = std::max(longest, script.units(*interval.upper));
  };
  for (const auto& skill : script.skills)
    if (skill.node->timeInterval) note(*skill.node->timeInterval);
  for (const auto* event : script.events)
    if (event->every) note(*event->every);
  for (const auto& thread : script.threads)
    for (const auto& place : thread.places)
      if (place.statement && waitsForTime(*place.statement)) note(place.statement->duration);
  for (auto& first : beginnings(script)) {
    if (hasWatch) first.ages.push_back({.counts = true});
    begins.insert(add(std::move(first)));
  }
  std::size_t next = 0;
  for (; next < all.size() && all.size() < limit; ++next) expand(next);
  finished = next == all.size();
}

std::size_t Runs::add(Situation situation) {
  situation = inOrder(std::move(situation));
  const auto [place, isNew] = known.try_emplace(situation, all.size());
  if (!isNew) return place->second;
  noteState(situation);
  all.push_back({std::move(situation), {}, {}, false});
  return place->second;
}

/// Fractions are numbered from 1 without gaps; an age beyond all bounds has none.
Situation Runs::inOrder(Situation situation) const {
  std::set<std::int64_t> fractions{0};
  for (auto& age : situation.ages) {
    if (age.counts && isPast(age, longest, false)) age = {.counts = true, .beyond = true};
    fractions.insert(age.fraction);
  }
  for (auto& age : situation.ages)
    age.fraction = std::distance(fractions.begin(), fractions.find(age.fraction));
  return situation;
}

void Runs::expand(std::size_t node) {
  const auto steps = stepsFrom(script, all[node].situation);
  std::vector<Edge> edges;
  for (const auto& step : steps) {
    if (!isDue(step.when, all[node].situation.ages)) continue;
    found.insert(step.facts.begin(), step.facts.end());
    edges.push_back({add(step.after), step.facts, hasToHappen(step, all[node].situation.ages)});
  }
  all[node].edges = std::move(edges);
  if (hasWatch) {
    Situation anew = all[node].situation;
    anew.ages.back() = {.counts = true};
    const auto restarted = add(std::move(anew));
    all[node].restarted = restarted;
  }
  letTimePass(node, steps);
}

void Runs::letTimePass(std::size_t node, const std::vector<Step>& steps) {
  if (std::ranges::any_of(steps, [](const Step& step) { return step.when.isUrgent(); })) return;
  Situation next = all[node].situation;
  next.ages = later(next.ages);
  const bool isLimit =
      std::ranges::any_of(steps, [&](const Step& step) { return isLate(step.when, next.ages); });
  const bool between = std::ranges::none_of(all[node].situation.ages, [](const Age& age) {
    return age.counts && !age.beyond && age.fraction == 0;
  });
  all[node].timePasses = between || !isLimit;
  if (!all[node].timePasses) return;
  for (std::size_t i = 0; i < script.skills.size(); ++i) {
    auto& skill = next.skills[i];
    if (skill.endedEarly)
      found.insert({What::Undershoot, static_cast<int>(i),
                    script.skills[i].node->timeInterval->range.begin});
    skill.endedEarly = false;
  }
  if (isLimit) return;
  const auto target = add(std::move(next));
  if (target != node) all[node].later = target;
}

/// Facts that last: reached statements, and skills that take too long.
void Runs::noteState(const Situation& situation) {
  for (std::size_t i = 0; i < script.threads.size(); ++i) {
    const auto& state = situation.threads[i];
    const auto& place = script.threads[i].places[state.place];
    const auto* statement = place.call ? place.call : place.statement;
    if (state.control == Control::Before && statement)
      found.insert({What::Reached, script.threads[i].skill, statement->range.begin});
  }
  for (std::size_t i = 0; i < script.skills.size(); ++i) {
    const auto& skill = script.skills[i];
    const auto& interval = skill.node->timeInterval;
    if (!skill.isComposite() || !interval || !interval->upper) continue;
    const auto& age = situation.ages[script.threads.size() + i];
    if (age.counts && isPast(age, script.units(*interval->upper), interval->upperOpen))
      found.insert({What::Overshoot, static_cast<int>(i), interval->range.begin});
  }
}

bool Runs::canStop() const {
  return std::ranges::any_of(
      all, [&](const Node& node) { return stepsFrom(script, node.situation).empty(); });
}

bool Runs::timeCanGoOn() const {
  std::vector<std::vector<std::size_t>> before(all.size());
  std::vector<std::size_t> todo;
  std::vector<bool> good(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const auto& edge : all[i].edges)
      if (edge.due) before[edge.target].push_back(i);
    good[i] = all[i].timePasses;
    if (good[i]) todo.push_back(i);
  }
  while (!todo.empty()) {
    const auto node = todo.back();
    todo.pop_back();
    for (const auto source : before[node]) {
      if (good[source]) continue;
      good[source] = true;
      todo.push_back(source);
    }
  }
  return std::ranges::all_of(good, std::identity{});
}

} // namespace proskill::meaning
