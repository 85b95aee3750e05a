#pragma once

#include "syntax/tree/ast.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::codegen {

struct BodyAutomaton;

/// A control state before a statement of a body, with its successors.
struct BodyState {
  std::string name;                             ///< as in the paper: `NS5`, `N3_T`
  const syntax::Statement* statement = nullptr; ///< null: the end of the body
  const syntax::Statement* cases = nullptr; ///< for a call that is tested by a `case`: this `case`
  /// The state after the statement: after a loop ends, after an `if` without a matching arm, the
  /// target of a `break` or `goto`. Empty if there is none: after an outcome and after an infinite
  /// loop.
  std::string next;
  /// First states of the parts. WaitCondition: of what follows its timeout; If, Case: of each arm,
  /// including `else`; While, DoUntil: of the body; Choose: of each branch.
  std::vector<std::string> targets;
  std::vector<BodyAutomaton> branches; ///< Parallel, Race

  /// The statement in the text. \pre this is not the end of the body
  [[nodiscard]] const syntax::Statement& source() const { return cases ? *cases : *statement; }
};

/// A body, or a parallel branch of one, as an automaton: a state before each statement in the order
/// of the text, but no state before a label. The first state of an arm or of a loop's body is named
/// after the test: `N1_T`, `N1_T2` for an `elseif`, `N1_F` for an `else`, `N1_C1` for a choice.
struct BodyAutomaton {
  std::string name;              ///< of the skill; for a branch `uav_mission_branch_1_0`
  std::vector<std::size_t> path; ///< position of a branch for users: 1-based, from the body inwards
  /// For a branch of a race: the other branches, which it stops when it ends.
  std::vector<std::string> rivals;
  std::vector<std::string> racers; ///< the branches of races that contain it, including itself
  syntax::Range range;             ///< of its statements, including their parentheses
  std::vector<BodyState> states;   ///< the end is last, if it is reachable from some state
  std::string entry;
  std::map<std::string_view, std::string> labels; ///< the state of each label
};

/// The automaton of a body. It refers to `body`. \pre the body has no errors
[[nodiscard]] BodyAutomaton bodyAutomaton(const syntax::Block& body, std::string_view name);

/// Visits the automaton, then its branches in the order of the text.
void forEachThread(const BodyAutomaton& automaton,
                   const std::function<void(const BodyAutomaton&)>& visit);

} // namespace proskill::codegen
