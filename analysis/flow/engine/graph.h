#pragma once

#include "syntax/tree/ast.h"

#include <cstdint>
#include <vector>

/// The control-flow graph of a skill or an environment: what may follow what, as the automata of
/// the model do it. It knows no names and no values; it looks into the typed tree.
namespace proskill::analysis::flow {

using NodeId = std::uint32_t;
using GraphId = std::uint32_t;
constexpr NodeId kNoNode = ~NodeId{0};

enum class NodeKind : std::uint8_t {
  Start,     ///< of a skill: preconditions, then start effects; of a branch or environment: nothing
  Refused,   ///< a precondition did not hold
  Run,       ///< the action of a basic skill
  Call,      ///< until the callee has returned
  Interrupt, ///< of another skill
  Wait,      ///< for a condition
  Delay,     ///< for some time
  Test,      ///< of an `if`, `while` or `do`
  Choose,
  Fork, ///< until all branches have ended; of a race, one, and the others have stopped
  Set,
  Emit,
  Step,  ///< a message, a jump, a label: nothing changes
  Leave, ///< `(success …)` or `(failure …)` in a branch: the branch ends, then the whole skill
  Outcome, ///< its effects are set, and the skill has ended
  InvariantFailure,
  Interrupted,
  End,
};

/// Which conditions of its node an edge needs.
enum class Guard : std::uint8_t { None, Holds, Fails };

struct Edge {
  NodeId target = kNoNode; ///< none: it has returned, without a start
  Guard guard = Guard::None;
  bool sets = false;  ///< the effects of the node happen on it
  bool stops = false; ///< taken instead of what the node does, or while it waits for what it called
};

/// A state of the automaton, with what its transitions do.
struct Node {
  NodeKind kind = NodeKind::Step;
  syntax::Range range;                          ///< the statement, the test, or the field
  const syntax::Statement* statement = nullptr; ///< null for what belongs to the skill itself
  std::vector<const syntax::Expr*> conditions;  ///< all must hold
  const syntax::Effects* effects = nullptr;
  const syntax::Outcome* outcome = nullptr; ///< Outcome; null where the body runs off its end
  const syntax::Invariant* invariant = nullptr;
  bool success = false;          ///< Outcome
  bool atomic = false;           ///< what it does happens in the step that leads to it
  std::vector<GraphId> branches; ///< Fork: graphs of the same skill
  std::vector<Edge> edges;

  /// Fork: the first branch to end ends the others.
  [[nodiscard]] bool isRace() const {
    return statement && statement->kind == syntax::StatementKind::Race && branches.size() > 1;
  }
  /// Time can pass here, so that the skill watches its guards and whether it is to stop.
  [[nodiscard]] bool waits() const {
    return kind == NodeKind::Call || kind == NodeKind::Wait || kind == NodeKind::Delay ||
           kind == NodeKind::Fork || kind == NodeKind::Run;
  }
};

/// One thread of control: a skill's own, or that of a branch.
struct Graph {
  std::vector<Node> nodes; ///< nodes[0] is the start
  NodeId end = kNoNode;    ///< it has returned; all exits but Refused and Leave lead here
  GraphId parent = 0;      ///< of a branch: the graph that it was forked in; of the first: itself
  NodeId fork = kNoNode;   ///< of a branch: the node in `parent`

  [[nodiscard]] const Node& operator[](NodeId id) const { return nodes[id]; }
};

/// The skill's own graph, then those of its branches.
struct SkillGraph {
  std::vector<Graph> graphs;
};

[[nodiscard]] SkillGraph buildGraph(const syntax::Skill& skill);
[[nodiscard]] SkillGraph buildGraph(const syntax::Environment& environment);

} // namespace proskill::analysis::flow
