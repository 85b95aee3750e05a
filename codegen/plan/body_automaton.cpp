#include "codegen/plan/body_automaton.h"

#include "syntax/tree/statements.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace proskill::codegen {
namespace {

using syntax::Block;
using syntax::Statement;
using syntax::StatementKind;

/// Whether control never falls through to the next statement. It may still get there from inner
/// statements or by `break`.
bool neverGoesOn(const Statement& statement) {
  switch (statement.kind) {
  case StatementKind::Success:
  case StatementKind::Failure:
  case StatementKind::Case: return true;
  case StatementKind::While: return statement.condition.kind == syntax::ExprKind::True;
  case StatementKind::DoUntil: return statement.condition.kind == syntax::ExprKind::False;
  case StatementKind::If: return !statement.arms.empty() && !statement.arms.back().condition;
  case StatementKind::Unknown:
  case StatementKind::Call:
  case StatementKind::Interrupt:
  case StatementKind::WaitCondition:
  case StatementKind::WaitTime:
  case StatementKind::Break:
  case StatementKind::Label:
  case StatementKind::Goto:
  case StatementKind::Parallel:
  case StatementKind::Race:
  case StatementKind::Set:
  case StatementKind::Printf:
  case StatementKind::Emit:
  case StatementKind::Choose: return false;
  }
  std::unreachable();
}

/// Names all states in the order of the text, then links each to its successors.
class Builder {
public:
  /// `parallels` counts the `//` and `race` of the skill, including those in branches.
  Builder(std::string_view skill, std::size_t& parallels) : skill(skill), parallels(parallels) {}

  BodyAutomaton build(const Block& body) {
    automaton.range = body.range;
    std::string none;
    nameBlock(body, none);
    const auto end = nextName(none);
    linkBlock(body, end, end);
    automaton.entry = entry(body, 0);
    for (const auto& [label, place] : labels)
      automaton.labels.emplace(label, entry(*place.block, place.index + 1));
    for (auto& state : automaton.states)
      if (state.statement->kind == StatementKind::Goto)
        state.next = automaton.labels.at(state.statement->name.text);
    if (isReferred(end)) addState(end, nullptr);
    return std::move(automaton);
  }

private:
  struct Place {
    const Block* block;
    std::size_t index;
  };

  void addState(std::string name, const Statement* statement) {
    BodyState state;
    state.name = std::move(name);
    state.statement = statement;
    automaton.states.push_back(std::move(state));
  }

  std::string nextName(std::string& first) {
    if (!first.empty()) return std::exchange(first, {});
    return "NS" + std::to_string(++statements);
  }

  /// `first` is the name reserved for the first state of the block, or empty.
  void nameBlock(const Block& block, std::string& first) {
    for (std::size_t i = 0; i < block.statements.size(); ++i) {
      const auto& statement = block.statements[i];
      if (statement.kind == StatementKind::Label)
        labels.emplace(statement.name.text, Place{&block, i});
      else
        nameStatement(statement, first);
    }
  }

  void nameInner(const Block& block, std::string first) { nameBlock(block, first); }

  void nameStatement(const Statement& statement, std::string& first) {
    if (statement.kind == StatementKind::DoUntil) nameBlock(statement.branches[0], first);
    const auto index = automaton.states.size();
    stateOf.emplace(&statement, index);
    const bool isCase = statement.kind == StatementKind::Case;
    addState(nextName(first), isCase ? syntax::callOf(statement) : &statement);
    if (isCase) automaton.states[index].cases = &statement;
    switch (statement.kind) {
    case StatementKind::If:
    case StatementKind::Case: return nameArms(statement);
    case StatementKind::While: return nameInner(statement.branches[0], nextTest() + "T");
    case StatementKind::Choose: return nameChoices(statement);
    case StatementKind::Parallel:
    case StatementKind::Race: automaton.states[index].branches = branches(statement); return;
    case StatementKind::WaitCondition:
      if (syntax::hasTimeout(statement)) nameInner(statement.branches[0], nextTest() + "L");
      return;
    case StatementKind::Unknown:
    case StatementKind::Call:
    case StatementKind::Interrupt:
    case StatementKind::WaitTime:
    case StatementKind::DoUntil:
    case StatementKind::Break:
    case StatementKind::Label:
    case StatementKind::Goto:
    case StatementKind::Set:
    case StatementKind::Printf:
    case StatementKind::Success:
    case StatementKind::Failure:
    case StatementKind::Emit: return;
    }
  }

  std::string nextTest() { return "N" + std::to_string(++tests) + "_"; }

  void nameArms(const Statement& statement) {
    const auto prefix = nextTest();
    for (std::size_t i = 0; i < statement.arms.size(); ++i) {
      const auto& arm = statement.arms[i];
      const auto suffix = !arm.condition ? "F" : i == 0 ? "T" : "T" + std::to_string(i + 1);
      nameInner(arm.body, prefix + suffix);
    }
  }

  void nameChoices(const Statement& statement) {
    const auto prefix = nextTest();
    for (std::size_t i = 0; i < statement.branches.size(); ++i)
      nameInner(statement.branches[i], prefix + "C" + std::to_string(i + 1));
  }

  std::vector<BodyAutomaton> branches(const Statement& statement) {
    const auto prefix = std::string(skill) + "_branch_" + std::to_string(++parallels) + "_";
    std::vector<BodyAutomaton> result;
    for (std::size_t i = 0; i < statement.branches.size(); ++i) {
      result.push_back(Builder(skill, parallels).build(statement.branches[i]));
      result.back().name = prefix + std::to_string(i);
    }
    return result;
  }

  [[nodiscard]] std::string entry(const Block& block, std::size_t index) const {
    for (; index < block.statements.size(); ++index) {
      const auto& statement = block.statements[index];
      if (statement.kind == StatementKind::Label) continue;
      if (statement.kind == StatementKind::DoUntil) return entry(statement.branches[0], 0);
      return automaton.states[stateOf.at(&statement)].name;
    }
    return follows.at(&block);
  }

  /// `next` follows the block, `afterLoop` the innermost surrounding loop. Links from the last
  /// statement to the first, since the entry of an empty loop is its successor.
  void linkBlock(const Block& block, const std::string& next, const std::string& afterLoop) {
    follows[&block] = next;
    for (std::size_t i = block.statements.size(); i-- > 0;)
      if (block.statements[i].kind != StatementKind::Label)
        linkStatement(block.statements[i], entry(block, i + 1), afterLoop);
  }

  void linkStatement(const Statement& statement, const std::string& next,
                     const std::string& afterLoop) {
    const auto index = stateOf.at(&statement);
    const auto own = automaton.states[index].name;
    automaton.states[index].next = neverGoesOn(statement)                   ? ""
                                   : statement.kind == StatementKind::Break ? afterLoop
                                                                            : next;
    if (syntax::runsBranches(statement)) return;
    const bool loops =
        statement.kind == StatementKind::While || statement.kind == StatementKind::DoUntil;
    for (const auto& arm : statement.arms) linkInner(arm.body, index, next, afterLoop);
    if (statement.kind == StatementKind::Case) return;
    for (const auto& block : statement.branches)
      linkInner(block, index, loops ? own : next, loops ? next : afterLoop);
  }

  void linkInner(const Block& block, std::size_t index, const std::string& next,
                 const std::string& afterLoop) {
    linkBlock(block, next, afterLoop);
    automaton.states[index].targets.push_back(entry(block, 0));
  }

  [[nodiscard]] bool isReferred(const std::string& name) const {
    const auto refers = [&](const BodyState& state) {
      return state.next == name || std::ranges::find(state.targets, name) != state.targets.end();
    };
    return automaton.entry == name || std::ranges::any_of(automaton.states, refers);
  }

  std::string_view skill;
  std::size_t& parallels;
  BodyAutomaton automaton;
  std::map<const Statement*, std::size_t> stateOf;
  std::map<const Block*, std::string> follows; ///< the state after each block
  std::map<std::string_view, Place> labels;
  std::size_t statements = 0;
  std::size_t tests = 0;
};

void enterRace(BodyAutomaton& branch, const std::vector<BodyAutomaton>& all) {
  for (const auto& other : all)
    if (other.name != branch.name) branch.rivals.push_back(other.name);
  if (!branch.rivals.empty()) branch.racers.push_back(branch.name);
}

/// Numbers the branches.
void placeBranches(BodyAutomaton& automaton) {
  for (auto& state : automaton.states)
    for (std::size_t i = 0; i < state.branches.size(); ++i) {
      auto& branch = state.branches[i];
      branch.path = automaton.path;
      branch.path.push_back(i + 1);
      branch.racers = automaton.racers;
      if (state.statement->kind == StatementKind::Race) enterRace(branch, state.branches);
      placeBranches(branch);
    }
}

} // namespace

BodyAutomaton bodyAutomaton(const Block& body, std::string_view name) {
  std::size_t parallels = 0;
  auto automaton = Builder(name, parallels).build(body);
  automaton.name = name;
  placeBranches(automaton);
  return automaton;
}

void forEachThread(const BodyAutomaton& automaton,
                   const std::function<void(const BodyAutomaton&)>& visit) {
  visit(automaton);
  for (const auto& state : automaton.states)
    for (const auto& branch : state.branches) forEachThread(branch, visit);
}

} // namespace proskill::codegen
