#pragma once

#include "syntax/tree/ast.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::codegen {

struct BodyAutomaton;

/// Where control stands before a statement, and where it goes from there.
struct BodyState {
  std::string name;                             ///< as the paper names it: `NS5`, `N3_T`
  const syntax::Statement* statement = nullptr; ///< null: the end of the body
  const syntax::Statement* cases = nullptr;     ///< of a call: the `case` that it is the call of
  /// Where control goes when the statement is done: of a loop when it ends, of an `if` when no arm
  /// is taken, of a `break` or `goto` its target. Empty where it goes nowhere: behind an outcome,
  /// and behind a loop for ever.
  std::string next;
  /// WaitCondition: of what follows its timeout; If, Case: the first state of each arm, an `else`
  /// included; While, DoUntil: of the body; Choose: of each branch.
  std::vector<std::string> targets;
  std::vector<BodyAutomaton> branches; ///< Parallel, Race

  /// What the text has there. \pre it is not the end of the body
  [[nodiscard]] const syntax::Statement& source() const { return cases ? *cases : *statement; }
};

/// A body, or a parallel branch of one, as an automaton: a state before each statement in the order
/// of the text, none before a label. The first state of an arm or of a loop's body is called after
/// the test: `N1_T`, `N1_T2` of an `elseif`, `N1_F` of an `else`, `N1_C1` of a choice.
struct BodyAutomaton {
  std::string name;                ///< of the skill; of a branch `uav_mission_branch_1_0`
  std::vector<std::size_t> path;   ///< of a branch: 1-based, from the body inwards; for people
  std::vector<std::string> rivals; ///< of a branch of a race: the others, which it ends by its end
  std::vector<std::string> racers; ///< the branches of races that it is within, itself included
  syntax::Range range;             ///< of its statements, with their parentheses
  std::vector<BodyState> states;   ///< the end stands last, where it can be reached from some state
  std::string entry;
  std::map<std::string_view, std::string> labels; ///< the state that control has at the label
};

/// The automaton of a body. \pre the body has no errors. It looks into `body`.
[[nodiscard]] BodyAutomaton bodyAutomaton(const syntax::Block& body, std::string_view name);

/// Visits the automaton, then the branches within it, in the order of the text.
void forEachThread(const BodyAutomaton& automaton,
                   const std::function<void(const BodyAutomaton&)>& visit);

} // namespace proskill::codegen
