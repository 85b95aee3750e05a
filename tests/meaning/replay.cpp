#include "tests/meaning/replay.h"

#include "tests/meaning/runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

namespace proskill::meaning {
namespace {

Values valuesIn(const Script& script, const Situation& now) {
  Values values;
  for (std::size_t i = 0; i < script.variables.size(); ++i) {
    const auto& variable = *script.variables[i];
    values[std::string(variable.name.text)] =
        variable.states.empty() ? std::to_string(now.values[i])
                                : std::string(variable.states[now.values[i]].text);
  }
  for (std::size_t i = 0; i < script.resources.size(); ++i)
    values[std::string(script.resources[i]->name.text) + " in use"] = std::to_string(now.used[i]);
  for (std::size_t i = 0; i < script.skills.size(); ++i)
    values[std::string(script.skills[i].node->name.text) + ".status"] =
        wordOf(now.skills[i].last.status);
  return values;
}

void apply(const std::vector<verify::Change>& changes, Values& values) {
  for (const auto& change : changes)
    if (const auto found = values.find(change.variable); found != values.end())
      found->second = change.after;
}

/// \pre time can pass: no step is urgent
std::vector<Age> after(std::vector<Age> ages, std::int64_t time, std::int64_t parts) {
  for (auto& age : ages) {
    if (!age.counts) continue;
    const auto whole = (age.fraction + time) / parts;
    age = {.counts = true, .whole = age.whole + whole, .fraction = (age.fraction + time) % parts};
  }
  return ages;
}

} // namespace

std::optional<std::string> Replays::whyNoRun(const verify::Trace& trace) const {
  const auto choices = static_cast<std::size_t>(std::ranges::count_if(
      script.variables, [](const auto* each) { return !each->otherInits.empty(); }));
  Situations now;
  for (auto& first : beginnings(script)) now.insert(std::move(first));
  const auto beginsWith = valuesIn(script, beginning(script));
  Values values = beginsWith;
  apply(trace.initial, values);
  if (values != beginsWith) return "it begins with other values";
  const auto perUnit = unit.numerator * script.unitsPerSecond;
  const auto parts = unit.denominator * trace.scale;
  std::int64_t date = 0;
  const auto passTo = [&](std::int64_t next) {
    if (next > date) now = later(script, closed(now), (next - date) * perUnit, parts);
    date = std::max(date, next);
    return !now.empty();
  };
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    const auto& step = trace.steps[i];
    if (!passTo(step.date))
      return fmt::format("so much time cannot pass before its step {}", i + 1);
    const Values before = values;
    apply(step.changes, values);
    if (i < choices) { // the first steps choose the initial values
      if (i + 1 < choices) continue;
      std::erase_if(now, [&](const auto& each) { return valuesIn(script, each) != values; });
      if (now.empty() || step.date > 0) return "it does not begin so";
      continue;
    }
    if (values != before) now = changed(closed(now), values);
    if (now.empty()) return fmt::format("nothing does what its step {} does at its date", i + 1);
  }
  if (!passTo(trace.end)) return "so much time cannot pass behind its last step";
  return std::nullopt;
}

Replays::Situations Replays::later(const Script& script, const Situations& now, std::int64_t time,
                                   std::int64_t parts) {
  Situations next;
  for (auto situation : now) {
    const auto steps = stepsFrom(script, situation);
    situation.ages = after(situation.ages, time, parts);
    for (auto& skill : situation.skills) skill.endedEarly = false;
    if (std::ranges::none_of(steps, [&](const Step& step) {
          return step.when.isUrgent() || isLate(step.when, situation.ages);
        }))
      next.insert(std::move(situation));
  }
  return next;
}

Replays::Situations Replays::changed(const Situations& now, const Values& to) const {
  Situations next;
  for (const auto& situation : now)
    for (auto& step : stepsFrom(script, situation))
      if (isDue(step.when, situation.ages) && valuesIn(script, step.after) == to)
        next.insert(std::move(step.after));
  return next;
}

Replays::Situations Replays::closed(Situations now) const {
  std::vector<Situation> todo(now.begin(), now.end());
  while (!todo.empty()) {
    const auto situation = std::move(todo.back());
    todo.pop_back();
    const auto values = valuesIn(script, situation);
    for (const auto& step : stepsFrom(script, situation))
      if (isDue(step.when, situation.ages) && valuesIn(script, step.after) == values &&
          now.insert(step.after).second)
        todo.push_back(step.after);
  }
  return now;
}

} // namespace proskill::meaning
