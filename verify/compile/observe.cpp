#include "verify/compile/observe.h"

#include "verify/monitor/buchi.h"
#include "verify/monitor/duration_monitor.h"
#include "verify/monitor/pattern_monitors.h"
#include "verify/unsupported.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace proskill::verify {

using fiacre::Observable;
using fiacre::ObservableKind;
using fiacre::PatternKind;

Observer::Observer(const fiacre::Program& asked, const Elaboration& of, Expressions& in,
                   Events& known, System& to)
    : program(asked), model(of), expressions(in), events(known), system(to) {}

Goal Observer::goal(const fiacre::Property& property) {
  const auto& pattern = property.pattern;
  if (pattern.kind == PatternKind::Ltl) return goalOfRuns(pattern.ltl);
  const bool plain = !pattern.after && !pattern.before && !pattern.until && !pattern.within &&
                     !pattern.forInterval && !pattern.forDuration && !pattern.lasting;
  if (plain)
    if (auto known = goalOfStates(pattern)) return *known;
  auto monitor = monitorOf(pattern, expressions.nodes(),
                           [this](const Observable& atom) { return node(atom); });
  if (!monitor)
    return {.kind = GoalKind::Unsupported,
            .reason = "the pattern has no meaning with this scope and these times"};
  return {.kind = GoalKind::Run, .monitor = std::move(*monitor)};
}

/// A formula may be too large; the other questions are still answered.
Goal Observer::goalOfRuns(const fiacre::Ltl& ltl) {
  const auto condition = [this](const Observable& atom) { return node(atom); };
  try {
    return {.kind = GoalKind::Run, .monitor = negated(ltl, expressions.nodes(), condition)};
  } catch (const CompileError& error) {
    return {.kind = GoalKind::Unsupported, .reason = error.why.message};
  }
}

/// The goal of a question that a single state or step answers.
std::optional<Goal> Observer::goalOfStates(const fiacre::Pattern& pattern) {
  switch (pattern.kind) {
  case PatternKind::Absent: return reach(pattern.operands.at(0));
  case PatternKind::Always:
    return reach({.kind = ObservableKind::Not, .operands = {pattern.operands.at(0)}});
  case PatternKind::DeadlockFree: {
    Goal goal{.kind = GoalKind::Deadlock, .condition = expressions.nodes().number(0)};
    for (const auto& allowed : pattern.operands)
      goal.condition = expressions.nodes().binary(NodeOp::Or, goal.condition, node(allowed));
    return goal;
  }
  case PatternKind::Progress: return Goal{.kind = GoalKind::Stuck};
  case PatternKind::NoError: return Goal{.kind = GoalKind::Error};
  case PatternKind::AlwaysReachable:
    return Goal{.kind = GoalKind::Lost, .condition = node(pattern.operands.at(0)), .ofSteps = true};
  case PatternKind::Longest: return duration(GoalKind::Longest, pattern);
  case PatternKind::Shortest: return duration(GoalKind::Shortest, pattern);
  case PatternKind::InfinitelyOften:
  case PatternKind::Mortal:
  case PatternKind::Present:
  case PatternKind::LeadsTo:
  case PatternKind::Precedes:
  case PatternKind::Ltl: return std::nullopt;
  }
  std::unreachable();
}

Goal Observer::duration(GoalKind kind, const fiacre::Pattern& pattern) {
  const NodeId from = node(pattern.operands.at(0));
  const NodeId to = node(pattern.operands.at(1));
  return {.kind = kind, .monitor = durationMonitor(system, expressions.nodes(), from, to)};
}

Goal Observer::reach(const Observable& observable) {
  Goal goal{.kind = GoalKind::Events};
  if (simple(observable, goal)) return goal;
  return {.kind = GoalKind::Condition,
          .condition = node(observable),
          .ofSteps = watchesSteps(observable)};
}

/// Adds states, tags and events, or a disjunction of them: observed when they are entered or
/// passed.
bool Observer::simple(const Observable& observable, Goal& goal) {
  switch (observable.kind) {
  case ObservableKind::State: {
    auto in = instance(observable);
    auto number = location(observable);
    goal.events.insert(events.entering(in, number));
    if (system.cells[system.instances[in].location].initial == number) goal.initially = true;
    return true;
  }
  case ObservableKind::Tag:
    for (auto event : tagEvents(observable)) goal.events.insert(event);
    return true;
  case ObservableKind::Event: goal.events.insert(portEvent(observable)); return true;
  case ObservableKind::Or:
    return std::ranges::all_of(observable.operands,
                               [&](const auto& part) { return simple(part, goal); });
  case ObservableKind::Value:
  case ObservableKind::Enter:
  case ObservableKind::Leave:
  case ObservableKind::Not:
  case ObservableKind::And:
  case ObservableKind::Implies: return false;
  }
  std::unreachable();
}

NodeId Observer::node(const Observable& observable) {
  auto& nodes = expressions.nodes();
  switch (observable.kind) {
  case ObservableKind::State: return stateNode(observable);
  case ObservableKind::Value: return valueNode(observable);
  case ObservableKind::Tag: return happens(tagEvents(observable));
  case ObservableKind::Event: return happens({portEvent(observable)});
  case ObservableKind::Enter: return nodes.unary(NodeOp::Entered, node(observable.operands.at(0)));
  case ObservableKind::Leave: return nodes.unary(NodeOp::Left, node(observable.operands.at(0)));
  case ObservableKind::Not: return nodes.negation(node(observable.operands.at(0)));
  case ObservableKind::And: return joined(observable, NodeOp::And);
  case ObservableKind::Or: return joined(observable, NodeOp::Or);
  case ObservableKind::Implies:
    return nodes.binary(NodeOp::Or, nodes.negation(node(observable.operands.at(0))),
                        node(observable.operands.at(1)));
  }
  unsupported("an unknown kind of observable");
}

NodeId Observer::joined(const Observable& observable, NodeOp op) {
  NodeId all = expressions.nodes().number(op == NodeOp::And);
  for (const auto& part : observable.operands)
    all = expressions.nodes().binary(op, all, node(part));
  return all;
}

NodeId Observer::stateNode(const Observable& observable) {
  auto& nodes = expressions.nodes();
  auto in = instance(observable);
  return nodes.equal(nodes.cell(system.instances[in].location), nodes.number(location(observable)));
}

/// A condition that fails, such as `10 / x > 2` for x = 0, counts as false.
NodeId Observer::valueNode(const Observable& observable) {
  const auto path = pathOf(program, observable);
  const auto component = model.scopeAt.find(path);
  const bool isWhole = path.empty() && !model.instanceAt.contains({});
  const Scope& scope = isWhole                            ? model.componentScope
                       : component != model.scopeAt.end() ? component->second
                                                          : model.scopes[instance(observable)];
  auto& nodes = expressions.nodes();
  const NodeId value = expressions.scalar(observable.value, scope);
  if (!expressions.mayFail(value)) return value;
  return nodes.both(nodes.negation(nodes.unary(NodeOp::Fails, value)), value);
}

NodeId Observer::happens(const std::vector<EventId>& of) {
  auto& nodes = expressions.nodes();
  NodeId any = nodes.number(0);
  for (auto event : of) any = nodes.binary(NodeOp::Or, any, nodes.happens(event));
  return any;
}

InstanceId Observer::instance(const Observable& observable) const {
  const auto found = model.instanceAt.find(pathOf(program, observable));
  if (found == model.instanceAt.end())
    unsupported("a property names an instance that the model does not have");
  return found->second;
}

std::uint32_t Observer::location(const Observable& observable) const {
  const auto& locations = system.instances[instance(observable)].locations;
  auto found = std::ranges::find(locations, observable.name);
  if (found == locations.end())
    unsupported("a property names the state `" + observable.name +
                "`, which its process does not have");
  return static_cast<std::uint32_t>(found - locations.begin());
}

std::vector<EventId> Observer::tagEvents(const Observable& observable) {
  const auto whole = pathOf(program, observable);
  const bool ofModel = observable.observer.empty();
  std::vector<EventId> all;
  const auto isWithin = [&](const ModelPath& path) { // these are adjacent in the map
    return path.size() >= whole.size() && std::equal(whole.begin(), whole.end(), path.begin());
  };
  for (auto at = model.instanceAt.lower_bound(whole);
       at != model.instanceAt.end() && isWithin(at->first); ++at)
    if (!ofModel || at->second < model.firstObserver)
      all.push_back(events.tag(at->second, observable.name));
  return all;
}

EventId Observer::portEvent(const Observable& observable) {
  const auto port = model.portAt.find({pathOf(program, observable), observable.name});
  if (port == model.portAt.end())
    unsupported("a property names the port `" + observable.name +
                "`, which the model does not have");
  return events.port(port->second);
}

} // namespace proskill::verify
