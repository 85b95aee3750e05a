#include "tests/support/oracle/judge.h"

#include <algorithm>

namespace proskill::oracle {

using fiacre::Observable;
using fiacre::ObservableKind;
using fiacre::PatternKind;

namespace {

std::optional<std::size_t> instanceAt(const Interpreter& model,
                                      const std::vector<std::uint32_t>& path) {
  auto found = std::ranges::find(model.instances(), path, &Instance::path);
  if (found == model.instances().end()) return std::nullopt;
  return found - model.instances().begin();
}

bool bearsTag(const Interpreter& model, const Observable& tag, const Firing& firing) {
  const auto path = model.pathOf(tag);
  return std::ranges::any_of(firing.tags, [&](const auto& borne) {
    const auto& at = model.instances()[borne.first].path;
    bool below = std::ranges::mismatch(path, at).in1 == path.end();
    if (path.empty() && at[0] == 0) below = false; // an observer is not part of the model
    return borne.second == tag.name && below;
  });
}

bool isEvent(const Interpreter& model, const Observable& event, const Firing& firing) {
  const auto is = [&](std::size_t slot) {
    const auto& port = model.ports()[slot];
    return port.name == event.name && port.component == model.pathOf(event);
  };
  return (firing.port && is(*firing.port)) || std::ranges::any_of(firing.watchers, is);
}

template <class Predicate> bool somewhere(const RegionGraph& graph, Predicate predicate) {
  return std::ranges::any_of(graph.nodes(), [&](const Node& node) {
    const DiscreteState& state = graph.discrete(node.discrete);
    if (predicate(Moment{&state.store, nullptr})) return true;
    return std::ranges::any_of(node.edges, [&](const Edge& edge) {
      return predicate(Moment{&state.store, &state.firings[edge.firing]});
    });
  });
}

bool canStop(const Interpreter& model, const RegionGraph& graph,
             const std::vector<Observable>& excluded) {
  return std::ranges::any_of(graph.nodes(), [&](const Node& node) {
    const DiscreteState& state = graph.discrete(node.discrete);
    return state.firings.empty() && std::ranges::none_of(excluded, [&](const auto& allowed) {
             return observed(model, allowed, {&state.store, nullptr});
           });
  });
}

/// The nodes from which steps without delay lead to one where time passes.
bool timeCanAlwaysPass(const RegionGraph& graph) {
  const auto& nodes = graph.nodes();
  std::vector<std::vector<std::size_t>> before(nodes.size());
  std::vector<std::size_t> todo;
  std::vector<bool> good(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const auto& edge : nodes[i].edges)
      if (edge.due) before[edge.target].push_back(i);
    good[i] = nodes[i].timePasses;
    if (good[i]) todo.push_back(i);
  }
  while (!todo.empty()) {
    std::size_t node = todo.back();
    todo.pop_back();
    for (std::size_t source : before[node]) {
      if (good[source]) continue;
      good[source] = true;
      todo.push_back(source);
    }
  }
  return std::ranges::all_of(good, std::identity{});
}

/// Whether every node has a way, by steps and time, to one that sees something.
template <class Predicate> bool alwaysLeadsTo(const RegionGraph& graph, Predicate sees) {
  const auto& nodes = graph.nodes();
  std::vector<std::vector<std::size_t>> before(nodes.size());
  std::vector<bool> good(nodes.size());
  std::vector<std::size_t> todo;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const DiscreteState& state = graph.discrete(nodes[i].discrete);
    good[i] = sees(Moment{&state.store, nullptr});
    for (const auto& edge : nodes[i].edges) {
      before[edge.target].push_back(i);
      good[i] = good[i] || sees(Moment{&state.store, &state.firings[edge.firing]});
    }
    if (nodes[i].later) before[*nodes[i].later].push_back(i);
    if (good[i]) todo.push_back(i);
  }
  while (!todo.empty()) {
    const std::size_t node = todo.back();
    todo.pop_back();
    for (std::size_t source : before[node]) {
      if (good[source]) continue;
      good[source] = true;
      todo.push_back(source);
    }
  }
  return std::ranges::all_of(good, std::identity{});
}

} // namespace

bool observed(const Interpreter& model, const Observable& observable, Moment moment) {
  const auto operand = [&](std::size_t i) {
    return observed(model, observable.operands[i], moment);
  };
  switch (observable.kind) {
  case ObservableKind::State: {
    auto instance = instanceAt(model, model.pathOf(observable));
    return instance && model.stateName(*instance, *moment.before) == observable.name;
  }
  case ObservableKind::Value:
    return model.holds(model.pathOf(observable), observable.value, *moment.before);
  case ObservableKind::Tag: return moment.firing && bearsTag(model, observable, *moment.firing);
  case ObservableKind::Event: return moment.firing && isEvent(model, observable, *moment.firing);
  case ObservableKind::Enter:
  case ObservableKind::Leave: {
    if (!moment.firing) return false;
    bool before = operand(0);
    bool after = observed(model, observable.operands[0], {&moment.firing->after, nullptr});
    return observable.kind == ObservableKind::Enter ? !before && after : before && !after;
  }
  case ObservableKind::Not: return !operand(0);
  case ObservableKind::And:
    return std::ranges::all_of(observable.operands,
                               [&](const auto& part) { return observed(model, part, moment); });
  case ObservableKind::Or:
    return std::ranges::any_of(observable.operands,
                               [&](const auto& part) { return observed(model, part, moment); });
  case ObservableKind::Implies: return !operand(0) || operand(1);
  }
  return false;
}

std::optional<bool> isTrue(const Interpreter& model, const RegionGraph& graph,
                           const fiacre::Pattern& pattern) {
  if (pattern.after || pattern.before || pattern.within || pattern.forInterval || pattern.lasting)
    return std::nullopt;
  const auto sees = [&](Moment moment) { return observed(model, pattern.operands[0], moment); };
  switch (pattern.kind) {
  case PatternKind::Absent: return !somewhere(graph, sees);
  case PatternKind::Always: return !somewhere(graph, [&](Moment moment) { return !sees(moment); });
  case PatternKind::DeadlockFree: return !canStop(model, graph, pattern.operands);
  case PatternKind::Progress: return timeCanAlwaysPass(graph);
  case PatternKind::AlwaysReachable: return alwaysLeadsTo(graph, sees);
  default: return std::nullopt;
  }
}

} // namespace proskill::oracle
