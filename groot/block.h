#pragma once

#include "analysis/program/program.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// Runs as viewers of behavior trees know them: Groot2's monitor protocol and its log files.
namespace proskill::groot {

enum class NodeKind : std::uint8_t {
  Control,  // a node with children; it runs while one of them does
  Choice,   // IfThenElse: its first child is a Test
  Parallel, // its children are the bodies of processes of their own
  Loop,     // Repeat, whose child has a Test at one of its ends
  Test,     // a condition, of a Choice or of a Loop
  Call,     // of a basic skill
  SubTree,  // a call of a composite skill
  Leaf,     // any other statement
  Timed,    // a wait with a timeout; its parent's second child is what follows the timeout
  Failing,  // a statement that ends the skill as a failure
};

using NodeIndex = std::uint32_t;

struct Node {
  NodeKind kind = NodeKind::Leaf;
  std::string tag; ///< the name of its XML element
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string skill;    ///< Call, SubTree: the callee
  NodeIndex parent = 0; ///< the root's: itself
  NodeIndex end = 0;    ///< index after its last descendant
};

/// The body of a composite skill as a tree, nodes in preorder: a node is followed by its
/// descendants.
struct Block {
  const analysis::Definition<syntax::Skill>* skill = nullptr; ///< null: not of a skill
  std::string name;
  std::vector<Node> nodes;
  /// By the range of a statement: the node that runs while a process is at the statement.
  std::map<std::pair<syntax::Offset, syntax::Offset>, NodeIndex> at;

  [[nodiscard]] bool contains(NodeIndex ancestor, NodeIndex node) const {
    return ancestor <= node && node < nodes[ancestor].end;
  }
};

/// The tree mirrors the body: its nodes show where a run is, but ticking them would not execute it.
[[nodiscard]] Block blockOf(const analysis::Program& program,
                            const analysis::Definition<syntax::Skill>& skill);

/// A tree that stands for a program with several skills that nobody calls.
[[nodiscard]] Block blockOf(const analysis::Program& program,
                            const std::vector<std::string>& skills);

} // namespace proskill::groot
