#include "codegen/plan/call_table.h"

#include <algorithm>

namespace proskill::codegen {

using syntax::Statement;
using syntax::StatementKind;

CallTable::CallTable(const analysis::Program& of, const GenerationPlan& with)
    : program(&of), plan(&with) {
  for (const auto& skill : plan->skills)
    if (skill.root) add(skill, {});
}

std::int64_t CallTable::add(const SkillPlan& skill, Values values) {
  values.resize(skill.skill().inputs.size());
  auto& known = sets[skill.name()];
  for (const auto& [number, set] : known)
    if (set == values) return number;
  const bool given = std::ranges::any_of(values, [](const auto& each) { return !each.empty(); });
  std::int64_t number = 0;
  if (given) number = known.empty() ? 1 : std::max<std::int64_t>(known.rbegin()->first + 1, 1);
  known.emplace(number, std::move(values));
  follow(skill, number);
  return number;
}

/// Adds the calls that a skill makes for this set of arguments.
void CallTable::follow(const SkillPlan& skill, std::int64_t number) {
  if (!skill.body) return;
  forEachThread(*skill.body, [&](const BodyAutomaton& thread) {
    for (const auto& state : thread.states) {
      if (!state.statement || state.statement->kind != StatementKind::Call) continue;
      const auto& callee = *plan->find(state.statement->head.text);
      const auto given = sets[skill.name()].at(number);
      const auto reached = add(callee, argumentsOf(*state.statement, callee, skill, given));
      auto& call = calls[state.statement];
      call.caller = skill.name();
      call.numbers[number] = reached;
    }
  });
}

CallTable::Values CallTable::argumentsOf(const Statement& call, const SkillPlan& callee,
                                         const SkillPlan& caller, const Values& given) const {
  Values values;
  for (const auto& input : callee.skill().inputs) {
    const auto bare = input.name.text.substr(1); // without the `$`
    const auto named = std::ranges::find_if(
        call.arguments, [&](const auto& argument) { return argument.name.text == bare; });
    values.push_back(named == call.arguments.end() ? "" : valueOf(named->value, caller, given));
  }
  return values;
}

/// A literal as written, also for a constant, or the value of the calling skill's own parameter.
std::string CallTable::valueOf(const syntax::Expr& expr, const SkillPlan& skill,
                               const Values& given) const {
  if (expr.kind == syntax::ExprKind::Parameter) {
    const auto& inputs = skill.skill().inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (inputs[i].name.text == expr.name.text) return given[i];
    return "";
  }
  const bool isConstant = expr.kind == syntax::ExprKind::Number && expr.name;
  const auto* constant = isConstant ? program->constants.find(expr.name.text) : nullptr;
  const auto range = constant ? (*constant)->value.range : expr.range;
  const auto& text = program->files[constant ? constant->file : skill.file()].document.text();
  return text.substr(range.begin, range.length());
}

const std::map<std::int64_t, std::int64_t>& CallTable::numbersOf(const Statement& call) const {
  static const std::map<std::int64_t, std::int64_t> none;
  const auto found = calls.find(&call);
  return found == calls.end() ? none : found->second.numbers;
}

std::string_view CallTable::callerOf(const Statement& call) const {
  const auto found = calls.find(&call);
  return found == calls.end() ? std::string_view() : found->second.caller;
}

std::int64_t CallTable::last() const {
  std::int64_t last = 0;
  for (const auto& [skill, known] : sets)
    if (!known.empty()) last = std::max(last, known.rbegin()->first);
  return last;
}

std::vector<ActionCall> CallTable::actions() const {
  std::vector<ActionCall> all;
  for (const auto& skill : plan->skills) {
    const auto known = sets.find(skill.name());
    const auto& action = skill.skill().action;
    if (known == sets.end() || !action) continue;
    for (const auto& [number, given] : known->second) {
      ActionCall call{.skill = std::string(skill.name()),
                      .number = number,
                      .command = std::string(action->command.text)};
      for (const auto& argument : action->arguments)
        call.arguments.push_back(valueOf(argument, skill, given));
      all.push_back(std::move(call));
    }
  }
  return all;
}

} // namespace proskill::codegen
