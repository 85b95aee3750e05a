#include "tests/meaning/replay.h"

#include "tests/meaning/look.h"

#include <fmt/format.h>

#include <algorithm>

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

} // namespace

Replays::Replays(const Script& of, const Runs& in) : script(of), runs(in) {
  for (const auto& node : runs.nodes()) {
    const auto values = valuesIn(script, node.situation);
    seen.push_back(numbers.try_emplace(values, numbers.size()).first->second);
  }
}

std::optional<std::string> Replays::whyNoRun(const verify::Trace& trace) const {
  const auto beginning = valuesIn(script, runs.nodes()[0].situation);
  Values values = beginning;
  apply(trace.initial, values);
  if (values != beginning) return "it begins with other values";
  Nodes now{0};
  std::int64_t date = 0;
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    const auto& step = trace.steps[i];
    if (step.date > date) now = later(now);
    if (now.empty()) return fmt::format("no time can pass before its step {}", i + 1);
    date = step.date;
    const Values before = values;
    apply(step.changes, values);
    if (values != before) now = changed(now, values);
    if (now.empty()) return fmt::format("nothing does what its step {} does", i + 1);
  }
  return std::nullopt;
}

Replays::Nodes Replays::later(const Nodes& nodes) const {
  Nodes next;
  for (const auto node : closed(nodes, false)) addLater(node, next);
  return closed(std::move(next), true);
}

Replays::Nodes Replays::changed(const Nodes& nodes, const Values& to) const {
  Nodes next;
  const auto wanted = numbers.find(to);
  if (wanted == numbers.end()) return next;
  for (const auto node : closed(nodes, false))
    for (const auto& edge : runs.nodes()[node].edges)
      if (seen[edge.target] == wanted->second) next.insert(edge.target);
  return next;
}

Replays::Nodes Replays::closed(Nodes nodes, bool time) const {
  std::vector<std::size_t> todo(nodes.begin(), nodes.end());
  while (!todo.empty()) {
    const auto at = todo.back();
    todo.pop_back();
    Nodes next;
    if (time) addLater(at, next);
    for (const auto& edge : runs.nodes()[at].edges)
      if (seen[edge.target] == seen[at]) next.insert(edge.target);
    for (const auto node : next)
      if (nodes.insert(node).second) todo.push_back(node);
  }
  return nodes;
}

/// A little time may pass within one order of the fractions, too.
void Replays::addLater(std::size_t at, Nodes& to) const {
  const auto& node = runs.nodes()[at];
  if (!node.timePasses) return;
  const bool between = std::ranges::none_of(node.situation.ages, [](const Age& age) {
    return age.counts && !age.beyond && age.fraction == 0;
  });
  if (between || !node.later) to.insert(at);
  if (node.later) to.insert(*node.later);
}

} // namespace proskill::meaning
