#include "tests/meaning/endless/fairness.h"

#include "graph/components.h"

#include <algorithm>
#include <map>

namespace proskill::meaning {
namespace {

bool takesAnyTime(const std::optional<syntax::Interval>& interval) {
  return !interval || !interval->upper;
}

bool isRunning(const Situation& now, std::size_t skill) {
  return now.skills[skill].phase == Phase::Running;
}

/// Whether the thread of a skill is in a wait without an upper bound of time.
bool waitsForTime(const Script& script, const Situation& now, std::size_t thread) {
  const auto& place = script.threads[thread].places[now.threads[thread].place];
  return script.threads[thread].skill != kNobody && place.statement &&
         now.threads[thread].control == Control::Before &&
         meaning::waitsForTime(*place.statement) && !place.statement->duration.upper;
}

/// Whether all nodes satisfy it.
template <class Holds> bool always(const Runs& runs, const Circle& circle, Holds holds) {
  return std::ranges::all_of(circle.nodes,
                             [&](std::size_t node) { return holds(runs.nodes()[node].situation); });
}

/// Something that must end lasts for ever.
bool lastsForEver(const Counted& counted, const Script& script, const Runs& runs,
                  const Circle& circle) {
  const auto mustEnd = [&](std::size_t skill) {
    return counted.ending.empty() || counted.ending.contains(script.skills[skill].node->name.text);
  };
  for (std::size_t i = 0; i < script.skills.size(); ++i)
    if (mustEnd(i) && !script.skills[i].isComposite() &&
        takesAnyTime(script.skills[i].node->timeInterval) &&
        always(runs, circle, [&](const auto& now) { return isRunning(now, i); }))
      return true;
  for (std::size_t i = 0; i < script.threads.size(); ++i)
    if (script.threads[i].skill != kNobody && mustEnd(script.threads[i].skill) &&
        always(runs, circle, [&](const auto& now) { return waitsForTime(script, now, i); }))
      return true;
  return false;
}

bool restartsOrIsBeyond(const Age& age) {
  return !age.counts || age.beyond || (age.whole == 0 && age.fraction == 0);
}

/// All ages are beyond all bounds, so nothing stops time.
bool isUnbounded(const Node& node) {
  return node.timePasses && std::ranges::all_of(node.situation.ages, [](const Age& age) {
           return !age.counts || age.beyond;
         });
}

bool isFair(const Counted& counted, const Script& script, const Runs& runs, const Circle& circle) {
  const bool passes = circle.timeGoesOn || std::ranges::any_of(circle.nodes, [&](std::size_t node) {
                        return isUnbounded(runs.nodes()[node]);
                      });
  if (!passes || lastsForEver(counted, script, runs, circle)) return false;
  const std::size_t ages = runs.nodes()[*circle.nodes.begin()].situation.ages.size();
  for (std::size_t i = 0; i < ages; ++i)
    if (std::ranges::none_of(circle.nodes, [&](std::size_t node) {
          return restartsOrIsBeyond(runs.nodes()[node].situation.ages[i]);
        }))
      return false;
  return true;
}

/// No step is possible, now or later.
bool isStuck(const Runs& runs, std::size_t node) {
  for (std::set<std::size_t> seen; seen.insert(node).second;) {
    if (!runs.nodes()[node].edges.empty()) return false;
    if (!runs.nodes()[node].later) return true;
    node = *runs.nodes()[node].later;
  }
  return true;
}

} // namespace

Counted countedBy(const syntax::Property& property) {
  Counted counted{.all = !property.fair.value_or(true)};
  for (const auto& skill : property.fairSkills) counted.ending.insert(skill.text);
  return counted;
}

bool counts(const Counted& counted, const Script& script, const Runs& runs, const Circle& circle) {
  return counted.all ? circle.hasStep : isFair(counted, script, runs, circle);
}

bool mayRest(const Counted& counted, const Script& script, const Runs& runs, std::size_t node) {
  if (counted.all) return isStuck(runs, node) || isUnbounded(runs.nodes()[node]);
  return isUnbounded(runs.nodes()[node]) &&
         !lastsForEver(counted, script, runs, {.nodes = {node}, .timeGoesOn = true});
}

std::vector<bool> goOn(const Counted& counted, const Script& script, const Runs& runs,
                       const std::vector<bool>& nodes, const Allowed& edge) {
  struct Way {
    std::size_t target;
    bool time;
  };
  const std::size_t count = nodes.size();
  std::vector<std::vector<Way>> ways(count);
  std::vector<std::vector<std::size_t>> before(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto add = [&](std::size_t target, bool time) {
      if (!nodes[i] || !nodes[target]) return;
      ways[i].push_back({target, time});
      before[target].push_back(i);
    };
    const auto& edges = runs.nodes()[i].edges;
    for (std::size_t k = 0; k < edges.size(); ++k)
      if (edge(i, k)) add(edges[k].target, false);
    if (runs.nodes()[i].later) add(*runs.nodes()[i].later, true);
  }
  const auto component = graph::componentsOf(count, [&](std::size_t at, std::size_t i) {
    return i < ways[at].size() ? static_cast<std::uint32_t>(ways[at][i].target) : graph::kNoNode;
  });
  std::map<std::size_t, Circle> circles;
  for (std::size_t i = 0; i < count; ++i)
    for (const auto& way : ways[i]) {
      if (component[way.target] != component[i]) continue;
      auto& circle = circles[component[i]];
      circle.nodes.insert({i, way.target});
      circle.timeGoesOn = circle.timeGoesOn || way.time;
      circle.hasStep = circle.hasStep || !way.time;
    }
  std::vector<bool> good(count);
  std::vector<std::size_t> todo;
  const auto mark = [&](std::size_t node) {
    if (good[node] || !nodes[node]) return;
    good[node] = true;
    todo.push_back(node);
  };
  for (const auto& [_, circle] : circles)
    if (counts(counted, script, runs, circle))
      for (auto node : circle.nodes) mark(node);
  for (std::size_t i = 0; i < count; ++i)
    if (mayRest(counted, script, runs, i)) mark(i);
  while (!todo.empty()) {
    const auto node = todo.back();
    todo.pop_back();
    for (auto source : before[node]) mark(source);
  }
  return good;
}

} // namespace proskill::meaning
