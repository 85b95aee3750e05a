#pragma once

#include "syntax/tree/ast.h"

#include <cstdint>
#include <vector>

/// The control-flow graph of a skill or an environment. It has the same steps as the automata of
/// the model. It contains neither resolved names nor values, and refers to the typed tree.
namespace proskill::analysis::flow {

using NodeId = std::uint32_t;
using GraphId = std::uint32_t;
constexpr NodeId kNoNode = ~NodeId{0};

enum class NodeKind : std::uint8_t {
  Start,   ///< of a skill: preconditions, then start effects; of a branch or environment: no effect
  Refused, ///< a precondition was false
  Run,     ///< the action of a basic skill
  Call,    ///< waits until the callee has returned
  Interrupt, ///< of another skill
  Wait,      ///< for a condition
  Delay,     ///< for some time
  Test,      ///< of an `if`, `while` or `do`
  Choose,
  /// Waits until all branches have ended; in a race: until one has ended and the others have
  /// stopped.
  Fork,
  Set,
  Emit,  ///< waits for the event's `:guard`, if there is one
  Step,  ///< a message, a jump or a label: no effect
  Leave, ///< `(success …)` or `(failure …)` in a branch: ends the branch, then the whole skill
  Outcome, ///< sets the outcome's effects and ends the skill
  InvariantFailure,
  Interrupted,
  End,
};

/// The value that the conditions of its node must have for an edge.
enum class Guard : std::uint8_t { None, Holds, Fails };

struct Edge {
  NodeId target = kNoNode; ///< kNoNode: the call has returned without a start
  Guard guard = Guard::None;
  bool sets = false;  ///< the node's effects happen on this edge
  bool stops = false; ///< a stop: instead of the node's action, or while it waits for its callees
};

/// A state of the automaton with the actions of its transitions.
struct Node {
  NodeKind kind = NodeKind::Step;
  syntax::Range range;                          ///< the statement, the test, or the field
  const syntax::Statement* statement = nullptr; ///< null if it belongs to the skill itself
  std::vector<const syntax::Expr*> conditions;  ///< all must hold
  const syntax::Effects* effects = nullptr;
  const syntax::Outcome* outcome = nullptr; ///< Outcome; null at the end of the body
  const syntax::Invariant* invariant = nullptr;
  bool success = false;          ///< Outcome
  bool atomic = false;           ///< its action happens in the step that leads to it
  std::vector<GraphId> branches; ///< Fork: graphs of the same skill
  std::vector<Edge> edges;

  /// Fork: the first branch to end stops the others.
  [[nodiscard]] bool isRace() const {
    return statement && statement->kind == syntax::StatementKind::Race && branches.size() > 1;
  }
  /// Whether time can pass here, so that the skill checks its guards and requests to stop.
  [[nodiscard]] bool waits() const {
    return kind == NodeKind::Call || kind == NodeKind::Wait || kind == NodeKind::Delay ||
           kind == NodeKind::Fork || kind == NodeKind::Run;
  }
};

/// A thread of control: a skill's own, or one of a branch.
struct Graph {
  std::vector<Node> nodes; ///< nodes[0] is the start
  NodeId end = kNoNode;    ///< the node after return; all exits except Refused and Leave lead to it
  GraphId parent = 0;      ///< of a branch: the graph that forks it; of the first graph: itself
  NodeId fork = kNoNode;   ///< of a branch: the node in `parent` that forks it

  [[nodiscard]] const Node& operator[](NodeId id) const { return nodes[id]; }
};

/// The graph of the skill itself, then those of its branches.
struct SkillGraph {
  std::vector<Graph> graphs;
};

[[nodiscard]] SkillGraph buildGraph(const syntax::Skill& skill);
[[nodiscard]] SkillGraph buildGraph(const syntax::Environment& environment);

} // namespace proskill::analysis::flow
