#include "tina/guide.h"

#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::tina {

using verify::Bits;
using verify::Goal;
using verify::GoalKind;
using verify::kNone;
using verify::StepLog;
using verify::TransitionSet;
using verify::Word;

namespace {

/// The system with a node that is always true, for `Guide::anything`.
verify::System withTruth(verify::System system) {
  system.nodes.push_back({.op = verify::NodeOp::Number, .number = 1});
  return withStateLayout(std::move(system));
}

std::string stepWords(std::size_t step, const std::string& name) {
  return "step " + std::to_string(step + 1) + ", `" + name + "`, ";
}

} // namespace

Guide::Guide(verify::Compiled compiled, const fiacre::Provenance& provenance,
             const std::string& main)
    : goals(std::move(compiled.goals)),
      anything{.kind = GoalKind::Condition,
               .condition = static_cast<verify::NodeId>(compiled.system.nodes.size())},
      system(withTruth(std::move(compiled.system))),
      enabling(system),
      names(system, main),
      unlimited(noLimits),
      witness(system, none, provenance, unlimited) {}

std::expected<std::unique_ptr<Guide>, verify::Unsupported>
Guide::make(const fiacre::Program& program, const fiacre::Provenance& provenance,
            const std::vector<verify::Question>& questions) {
  auto compiled = verify::compile(program, provenance, questions);
  if (!compiled) return std::unexpected(compiled.error());
  return std::unique_ptr<Guide>(new Guide(std::move(*compiled), provenance, program.main));
}

/// The transitions of these instances that are enabled apart from time. Those with exactly these
/// numbers come first.
std::vector<Guide::Taken> Guide::possible(const std::vector<Word>& state,
                                          const std::vector<Names::Part>& parts) const {
  std::vector<Taken> all;
  TransitionSet enabled;
  enabling.compute(state.data(), enabled);
  StepLog log;
  verify::eachIn(enabled, [&](verify::TransitionId id) {
    const auto& transition = system.transitions[id];
    const bool same = std::ranges::equal(
        transition.parts, parts, {}, [&](auto path) { return system.paths[path].instance; },
        &Names::Part::instance);
    if (!same || enabling.isBlocked(id, enabled)) return;
    Taken taken{.transition = id, .state = state};
    log.clear();
    if (fire(system, id, taken.state.data(), log) != verify::Outcome::Done) return;
    taken.exact = std::ranges::equal(log.leaves, parts, {}, {}, &Names::Part::leaf);
    for (auto event : log.events) taken.events.insert(event);
    all.push_back(std::move(taken));
  });
  std::ranges::stable_partition(all, &Taken::exact);
  return all;
}

/// Whether replaying the step may be useful.
bool Guide::maySee(const Goal& goal, const std::vector<Word>& before,
                   const std::vector<Word>& after, const Bits& events) const {
  switch (goal.kind) {
  case GoalKind::Events: return events.meets(goal.events);
  case GoalKind::Condition:
    return holdsAt(system, goal.condition, {after.data(), nullptr, nullptr}) ||
           holdsAt(system, goal.condition, {before.data(), after.data(), &events});
  case GoalKind::Deadlock: {
    TransitionSet enabled;
    enabling.compute(after.data(), enabled);
    return std::ranges::all_of(enabled, [](Word word) { return word == 0; }) &&
           !holdsAt(system, goal.condition, {after.data()});
  }
  default: return false;
  }
}

bool Guide::seesAtOnce(const Goal& goal, const std::vector<Word>& first) const {
  return goal.initially || maySee(goal, first, first, {});
}

verify::Steps Guide::wayTo(const std::vector<Node>& nodes, std::uint32_t node) {
  verify::Steps steps;
  for (; nodes[node].parent != kNone; node = nodes[node].parent)
    if (nodes[node].transition != kNone) steps.push_back(nodes[node].transition);
  std::ranges::reverse(steps);
  return steps;
}

std::expected<verify::Trace, std::string>
Guide::follow(std::size_t question, const std::vector<std::string>& transitions) const {
  std::vector<std::vector<Names::Part>> steps;
  std::string unknown;
  for (std::size_t i = 0; i < transitions.size(); ++i) {
    if (auto parts = names.transition(transitions[i])) {
      steps.push_back(std::move(*parts));
      continue;
    }
    if (unknown.empty())
      unknown = stepWords(i, transitions[i]) + "is not a transition of the model";
    // a step of an observer alone is not a step of the model
    if (auto some = names.partsWithin(transitions[i]); !some.empty()) steps.push_back(some);
  }
  const bool judged = judges(question);
  const Goal& goal = judged ? goals[question] : anything;
  // frac may number transitions differently, so the next attempt compares participants only
  auto strict = follow(goal, steps, !judged, true);
  if (strict) return strict;
  auto lenient = follow(goal, steps, !judged, false);
  if (lenient) return lenient;
  return unknown.empty() ? strict : std::unexpected(unknown);
}

std::expected<verify::Trace, std::string>
Guide::follow(const Goal& goal, const std::vector<std::vector<Names::Part>>& steps, bool toEnd,
              bool exactly) const {
  constexpr std::size_t kMost = 64; // maximum number of interpretations of a step
  std::vector<Node> nodes{{initialState(system)}};
  std::string why = "the steps do not lead to a violation";
  const auto attempt = [&](std::uint32_t node) {
    auto trace = witness.trace(goal, {wayTo(nodes, node), {}});
    if (!trace) why = trace.error();
    return trace;
  };
  if (toEnd ? steps.empty() : seesAtOnce(goal, nodes[0].state))
    if (auto trace = attempt(0)) return trace;
  std::vector<std::uint32_t> here{0};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::vector<std::uint32_t> there;
    for (auto from : here) {
      const auto before = nodes[from].state;
      for (auto& taken : possible(before, steps[i])) {
        if (there.size() == kMost || (exactly && !taken.exact)) break;
        const auto node = static_cast<std::uint32_t>(nodes.size());
        const bool seen =
            toEnd ? i + 1 == steps.size() : maySee(goal, before, taken.state, taken.events);
        const bool twice = std::ranges::any_of(
            there, [&](auto other) { return nodes[other].state == taken.state; });
        if (twice && !seen) continue;
        nodes.push_back({std::move(taken.state), from, taken.transition});
        there.push_back(node);
        if (seen)
          if (auto trace = attempt(node)) return trace;
      }
    }
    if (there.empty())
      return std::unexpected("step " + std::to_string(i + 1) + " is not possible in the model");
    here = std::move(there);
  }
  return std::unexpected(why);
}

/// Whether the properties of a node of the graph are true in the state.
bool Guide::agrees(const std::vector<Word>& state, const KtzGraph& graph,
                   std::uint32_t node) const {
  for (const auto& [property, value] : graph.states[node].has) {
    const auto& name = graph.properties[property];
    if (const auto place = names.place(name)) {
      const auto at = readCell(system, system.instances[place->instance].location, state.data());
      if (at != place->location) return false;
    } else if (const auto cell = names.variable(name)) {
      if (readCell(system, *cell, state.data()) != value) return false;
    }
  }
  return true;
}

std::expected<std::optional<verify::Trace>, std::string>
Guide::search(std::size_t question, const KtzGraph& graph) const {
  const Goal& goal = goals[question];
  std::vector<Node> nodes{{initialState(system)}};
  std::vector<std::uint32_t> nodeOf(graph.states.size(), kNone);
  std::vector<std::uint32_t> stateOf{0};
  nodeOf[0] = 0;
  if (!agrees(nodes[0].state, graph, 0))
    return std::unexpected("the first state of the graph is not that of the model");
  const auto trace =
      [&](std::uint32_t node) -> std::expected<std::optional<verify::Trace>, std::string> {
    auto made = witness.trace(goal, {wayTo(nodes, node), {}});
    if (!made) return std::unexpected(made.error());
    return std::move(*made);
  };
  if (seesAtOnce(goal, nodes[0].state)) return trace(0);
  for (std::uint32_t at = 0; at < nodes.size(); ++at) {
    const auto before = nodes[at].state;
    for (const auto& [label, target] : graph.states[stateOf[at]].edges) {
      const auto& name = graph.labels[label];
      const auto parts = names.transition(name).value_or(names.partsWithin(name));
      auto all = parts.empty() ? std::vector<Taken>{{.state = before}} : possible(before, parts);
      auto found = std::ranges::find_if(all, [&, target = target](const Taken& taken) {
        return agrees(taken.state, graph, target);
      });
      if (found == all.end())
        return std::unexpected("`" + name +
                               "` is not possible in the model where the graph has it, in state " +
                               std::to_string(stateOf[at]));
      const bool seen = !parts.empty() && maySee(goal, before, found->state, found->events);
      if (nodeOf[target] != kNone && !seen) continue;
      const auto node = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back({std::move(found->state), at, found->transition});
      stateOf.push_back(target);
      if (nodeOf[target] == kNone) nodeOf[target] = node;
      if (seen) return trace(node);
    }
  }
  return std::optional<verify::Trace>();
}

} // namespace proskill::tina
