#include "analysis/flow/engine/graph.h"

#include "syntax/tree/statements.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace proskill::analysis::flow {

namespace {

using namespace syntax;

const Outcome* findOutcome(const syntax::List<Outcome>& outcomes, std::string_view tag) {
  auto found = std::ranges::find(outcomes, tag, [](const Outcome& o) { return o.tag.text; });
  return found == outcomes.end() ? nullptr : &*found;
}

/// Whether it is a step of a body, before which guards are tested.
bool isStep(const Node& node) {
  return !node.atomic && (node.statement || node.kind == NodeKind::Outcome);
}

/// An edge without a target.
struct Loose {
  NodeId from = kNoNode;
  std::size_t edge = 0;
};
using LooseEnds = std::vector<Loose>;

/// Turns the statements of a thread into a graph, and those of its branches into further graphs.
class Builder {
public:
  Builder(SkillGraph& all, const Skill* skill, GraphId id) : all(all), skill(skill), id(id) {}

  void skillThread();
  void bodyThread(const Block& body, Range start);

private:
  Graph& graph() { return all.graphs[id]; }
  NodeId add(Node node);
  Loose edge(NodeId from, Guard guard = Guard::None, bool sets = false);
  void connect(const LooseEnds& ends, NodeId target);
  void connect(NodeId from, NodeId target, bool sets) {
    connect({edge(from, Guard::None, sets)}, target);
  }
  /// Adds a node for the statement after `ends`.
  NodeId place(NodeKind kind, const Statement& statement, const LooseEnds& ends);
  LooseEnds simple(NodeKind kind, const Statement& statement, const LooseEnds& ends);

  LooseEnds block(const Block& block, LooseEnds ends);
  LooseEnds statement(const Statement& statement, LooseEnds ends);
  LooseEnds wait(const Statement& statement, const LooseEnds& ends);
  LooseEnds conditional(const Statement& statement, LooseEnds ends);
  LooseEnds outcomes(const Statement& statement, LooseEnds ends);
  LooseEnds whileLoop(const Statement& statement, const LooseEnds& ends);
  LooseEnds untilLoop(const Statement& statement, LooseEnds ends);
  LooseEnds choice(const Statement& statement, const LooseEnds& ends);
  LooseEnds fork(const Statement& statement, const LooseEnds& ends);
  void finish(const Statement& statement, const LooseEnds& ends);
  NodeId test(const Statement& statement, const Expr& condition, const LooseEnds& ends);

  NodeId outcome(const Outcome* outcome, bool success, Range range, const Statement* statement);
  void leaveFrom(NodeId fork, const Block& block);
  void resolveJumps();
  void addStops(NodeId node, const std::vector<NodeId>& exits);
  void addExits(const syntax::List<Outcome>& outcomes, bool success, NodeId run);

  SkillGraph& all;
  const Skill* skill; ///< null for an environment
  GraphId id;
  std::vector<std::pair<std::string_view, NodeId>> labels;
  std::vector<std::pair<std::string_view, Loose>> jumps;
  std::vector<LooseEnds> breaks; ///< of the surrounding loops
};

NodeId Builder::add(Node node) {
  graph().nodes.push_back(std::move(node));
  return static_cast<NodeId>(graph().nodes.size() - 1);
}

Loose Builder::edge(NodeId from, Guard guard, bool sets) {
  auto& edges = graph().nodes[from].edges;
  edges.push_back({.guard = guard, .sets = sets});
  return {from, edges.size() - 1};
}

void Builder::connect(const LooseEnds& ends, NodeId target) {
  for (const Loose& end : ends) graph().nodes[end.from].edges[end.edge].target = target;
}

NodeId Builder::place(NodeKind kind, const Statement& statement, const LooseEnds& ends) {
  NodeId node = add({.kind = kind, .range = statement.range, .statement = &statement});
  connect(ends, node);
  return node;
}

LooseEnds Builder::simple(NodeKind kind, const Statement& statement, const LooseEnds& ends) {
  return {edge(place(kind, statement, ends))};
}

LooseEnds Builder::block(const Block& block, LooseEnds ends) {
  for (const Statement& next : block.statements) ends = statement(next, std::move(ends));
  return ends;
}

LooseEnds Builder::statement(const Statement& s, LooseEnds ends) {
  switch (s.kind) {
  case StatementKind::Call: return simple(NodeKind::Call, s, ends);
  case StatementKind::Interrupt: return simple(NodeKind::Interrupt, s, ends);
  case StatementKind::WaitTime: return simple(NodeKind::Delay, s, ends);
  case StatementKind::Emit: return {edge(place(NodeKind::Emit, s, ends), Guard::Holds, true)};
  case StatementKind::Unknown:
  case StatementKind::Printf: return simple(NodeKind::Step, s, ends);
  case StatementKind::WaitCondition: return wait(s, ends);
  case StatementKind::If: return conditional(s, std::move(ends));
  case StatementKind::Case: return outcomes(s, std::move(ends));
  case StatementKind::While: return whileLoop(s, ends);
  case StatementKind::DoUntil: return untilLoop(s, std::move(ends));
  case StatementKind::Choose: return choice(s, ends);
  case StatementKind::Parallel:
  case StatementKind::Race: return fork(s, ends);
  case StatementKind::Set: {
    NodeId node = place(NodeKind::Set, s, ends);
    graph().nodes[node].effects = &s.effects;
    return {edge(node, Guard::None, true)};
  }
  case StatementKind::Label: {
    NodeId node = place(NodeKind::Step, s, ends);
    labels.emplace_back(s.name.text, node);
    return {edge(node)};
  }
  case StatementKind::Goto:
    jumps.emplace_back(s.name.text, edge(place(NodeKind::Step, s, ends)));
    return {};
  case StatementKind::Break: {
    Loose out = edge(place(NodeKind::Step, s, ends));
    if (breaks.empty()) return {out}; // reported elsewhere; ignored here
    breaks.back().push_back(out);
    return {};
  }
  case StatementKind::Success:
  case StatementKind::Failure: finish(s, ends); return {};
  }
  return ends;
}

LooseEnds Builder::wait(const Statement& s, const LooseEnds& ends) {
  NodeId node = place(NodeKind::Wait, s, ends);
  graph().nodes[node].conditions = {&s.condition};
  graph().nodes[node].effects = &s.effects;
  LooseEnds after{edge(node, Guard::Holds, true)};
  if (!hasTimeout(s)) return after;
  const LooseEnds late = block(s.branches[0], {edge(node)});
  after.insert(after.end(), late.begin(), late.end());
  return after;
}

NodeId Builder::test(const Statement& s, const Expr& condition, const LooseEnds& ends) {
  NodeId node = place(NodeKind::Test, s, ends);
  graph().nodes[node].conditions = {&condition};
  graph().nodes[node].range = condition.range;
  return node;
}

LooseEnds Builder::conditional(const Statement& s, LooseEnds ends) {
  LooseEnds after;
  for (const Arm& arm : s.arms) {
    if (arm.condition) {
      NodeId node = test(s, *arm.condition, ends);
      graph().nodes[node].atomic = &arm != s.arms.data(); // all conditions are tested at the same
                                                          // moment
      ends = block(arm.body, {edge(node, Guard::Holds)});
      after.insert(after.end(), ends.begin(), ends.end());
      ends = {edge(node, Guard::Fails)};
    } else {
      ends = block(arm.body, std::move(ends));
    }
  }
  after.insert(after.end(), ends.begin(), ends.end());
  return after;
}

/// All arms are tried in the step in which the call returns. One of them matches, so no path
/// continues after the last.
LooseEnds Builder::outcomes(const Statement& s, LooseEnds ends) {
  if (const Statement* call = callOf(s)) ends = simple(NodeKind::Call, *call, ends);
  LooseEnds after;
  for (const Arm& arm : s.arms) {
    const bool isLast = &arm == &s.arms.back();
    LooseEnds others;
    if (arm.condition) {
      NodeId node = test(s, *arm.condition, ends);
      graph().nodes[node].atomic = true;
      ends = {edge(node, Guard::Holds)};
      if (!isLast) others = {edge(node, Guard::Fails)};
    }
    ends = block(arm.body, std::move(ends));
    after.insert(after.end(), ends.begin(), ends.end());
    ends = std::move(others);
  }
  return s.arms.empty() ? ends : after;
}

LooseEnds Builder::whileLoop(const Statement& s, const LooseEnds& ends) {
  NodeId node = test(s, s.condition, ends);
  breaks.emplace_back();
  LooseEnds round{edge(node, Guard::Holds)};
  if (!s.branches.empty()) round = block(s.branches.front(), std::move(round));
  connect(round, node);
  LooseEnds after = std::move(breaks.back());
  breaks.pop_back();
  after.push_back(edge(node, Guard::Fails));
  return after;
}

LooseEnds Builder::untilLoop(const Statement& s, LooseEnds ends) {
  auto first = static_cast<NodeId>(graph().nodes.size());
  breaks.emplace_back();
  if (!s.branches.empty()) ends = block(s.branches.front(), std::move(ends));
  NodeId node = test(s, s.condition, ends);
  LooseEnds after = std::move(breaks.back());
  breaks.pop_back();
  connect({edge(node, Guard::Fails)}, first);
  after.push_back(edge(node, Guard::Holds));
  return after;
}

LooseEnds Builder::choice(const Statement& s, const LooseEnds& ends) {
  NodeId node = place(NodeKind::Choose, s, ends);
  LooseEnds after;
  for (const Block& branch : s.branches) {
    LooseEnds out = block(branch, {edge(node)});
    after.insert(after.end(), out.begin(), out.end());
  }
  if (s.branches.empty()) after.push_back(edge(node));
  return after;
}

LooseEnds Builder::fork(const Statement& s, const LooseEnds& ends) {
  NodeId node = place(NodeKind::Fork, s, ends);
  for (const Block& branch : s.branches) {
    auto branchId = static_cast<GraphId>(all.graphs.size());
    all.graphs.push_back({.nodes = {}, .parent = id, .fork = node});
    graph().nodes[node].branches.push_back(branchId);
    Builder(all, skill, branchId).bodyThread(branch, branch.range);
    if (id == 0) leaveFrom(node, branch);
  }
  return {edge(node)};
}

/// The outcomes with which a branch, or a nested branch, may end the skill.
void Builder::leaveFrom(NodeId fork, const Block& block) {
  for (const Statement& s : block.statements) {
    bool success = s.kind == StatementKind::Success;
    if (skill && (success || s.kind == StatementKind::Failure)) {
      const Outcome* found = findOutcome(success ? skill->successes : skill->failures, s.name.text);
      Loose stop = edge(fork);
      graph().nodes[fork].edges[stop.edge].stops = true;
      connect({stop}, outcome(found, success, s.range, &s));
    }
    for (const Arm& arm : s.arms) leaveFrom(fork, arm.body);
    for (const Block& branch : s.branches) leaveFrom(fork, branch);
  }
}

void Builder::finish(const Statement& s, const LooseEnds& ends) {
  bool success = s.kind == StatementKind::Success;
  if (id != 0 || !skill) {
    place(NodeKind::Leave, s, ends);
    return;
  }
  const Outcome* found = findOutcome(success ? skill->successes : skill->failures, s.name.text);
  connect(ends, outcome(found, success, s.range, &s));
}

NodeId Builder::outcome(const Outcome* outcome, bool success, Range range,
                        const Statement* statement) {
  NodeId node = add({.kind = NodeKind::Outcome,
                     .range = range,
                     .statement = statement,
                     .effects = outcome ? &outcome->effects : nullptr,
                     .outcome = outcome,
                     .success = success});
  connect(node, graph().end, true);
  return node;
}

void Builder::resolveJumps() {
  for (const auto& [label, from] : jumps) {
    auto found = std::ranges::find(labels, label, [](const auto& known) { return known.first; });
    connect({from}, found == labels.end() ? graph().end : found->second);
  }
}

/// Adds the edges for a failed invariant and, where the node waits, for a stop request.
void Builder::addStops(NodeId node, const std::vector<NodeId>& exits) {
  for (NodeId exit : exits) {
    Loose stop = edge(node);
    graph().nodes[node].edges[stop.edge].stops = true;
    connect({stop}, exit);
  }
}

void Builder::addExits(const syntax::List<Outcome>& outcomes, bool success, NodeId run) {
  for (const Outcome& each : outcomes) {
    Loose out = edge(run);
    connect({out}, outcome(&each, success, each.range, nullptr));
  }
}

void Builder::bodyThread(const Block& body, Range start) {
  NodeId first = add({.kind = NodeKind::Start, .range = start});
  graph().end = add({.kind = NodeKind::End, .range = {start.end, start.end}});
  connect(block(body, {edge(first)}), graph().end);
  resolveJumps();
}

void Builder::skillThread() {
  Node start{.kind = NodeKind::Start, .range = skill->name.range, .effects = &skill->start};
  for (const Precondition& each : skill->preconditions) start.conditions.push_back(&each.condition);
  NodeId first = add(std::move(start));
  graph().end = add({.kind = NodeKind::End, .range = skill->name.range});
  if (!skill->preconditions.empty() && !skill->armed) {
    NodeId refused = add({.kind = NodeKind::Refused, .range = skill->name.range, .atomic = true});
    connect({edge(first, Guard::Fails)}, refused);
    edge(refused, Guard::None, true);
  }
  std::vector<NodeId> failures;
  for (const Invariant& each : skill->invariants) {
    NodeId node = add({.kind = NodeKind::InvariantFailure,
                       .range = each.range,
                       .conditions = {&each.guard},
                       .effects = &each.effects,
                       .invariant = &each});
    connect(node, graph().end, true);
    failures.push_back(node);
  }
  NodeId stopped = add({.kind = NodeKind::Interrupted,
                        .range = skill->interrupt ? skill->interrupt->range : skill->name.range,
                        .effects = skill->interrupt ? &skill->interrupt->effects : nullptr});
  connect(stopped, graph().end, true);
  std::vector<NodeId> exits = failures;
  if (!skill->unstoppable) exits.push_back(stopped);
  Loose started = edge(first, Guard::Holds, true);
  if (skill->body) {
    LooseEnds ends = block(*skill->body, {started});
    connect(ends,
            outcome(nullptr, true, {skill->body->range.end, skill->body->range.end}, nullptr));
    resolveJumps();
  } else {
    NodeId run = add(
        {.kind = NodeKind::Run, .range = skill->action ? skill->action->range : skill->name.range});
    connect({started}, run);
    addExits(skill->successes, true, run);
    addExits(skill->failures, false, run);
    if (skill->successes.empty())
      connect(run, outcome(nullptr, true, skill->name.range, nullptr), false);
  }
  auto count = static_cast<NodeId>(graph().nodes.size());
  for (NodeId node = 0; node < count; ++node) {
    if (graph().nodes[node].waits())
      addStops(node, exits);
    else if (skill->isComposite() && isStep(graph().nodes[node]))
      addStops(node, failures);
  }
}

} // namespace

SkillGraph buildGraph(const syntax::Skill& skill) {
  SkillGraph result;
  result.graphs.emplace_back();
  Builder(result, &skill, 0).skillThread();
  return result;
}

SkillGraph buildGraph(const syntax::Environment& environment) {
  SkillGraph result;
  result.graphs.emplace_back();
  Builder(result, nullptr, 0).bodyThread(environment.body, environment.name.range);
  return result;
}

} // namespace proskill::analysis::flow
