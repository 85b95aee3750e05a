#include "tests/meaning/inputs.h"

#include "syntax/tree/statements.h"

#include <algorithm>

namespace proskill::meaning {
namespace {

using syntax::Expr;
using syntax::ExprKind;

/// Notes each place of a skill at which one of its inputs is read or passed on.
class Finder {
public:
  Finder(Script& made, int number) : script(made), skill(number) {}

  void find() {
    const auto& node = *script.skills[skill].node;
    for (const auto& each : node.preconditions) expr(each.condition);
    effects(node.start);
    for (const auto& each : node.invariants) expr(each.guard), effects(each.effects);
    if (node.interrupt) effects(node.interrupt->effects);
    outcomes(node.successes);
    outcomes(node.failures);
    if (node.body)
      syntax::forEachStatement(*node.body, [&](const syntax::Statement& each) { statement(each); });
  }

private:
  void statement(const syntax::Statement& each) {
    expr(each.condition);
    effects(each.effects);
    for (const auto& arm : each.arms)
      if (arm.condition) expr(*arm.condition);
    if (each.kind == syntax::StatementKind::Call)
      for (const auto& argument : each.arguments) expr(argument.value);
  }

  void outcomes(const syntax::List<syntax::Outcome>& all) {
    for (const auto& each : all) {
      effects(each.effects);
      if (each.postcondition) expr(*each.postcondition);
    }
  }

  void effects(const syntax::Effects& all) {
    for (const auto& each : all.items) expr(each.value);
  }

  void expr(const Expr& each) {
    for (const auto& operand : each.operands) expr(operand);
    if (each.kind != ExprKind::Parameter) return;
    const auto& inputs = script.skills[skill].node->inputs;
    for (const auto& input : inputs)
      if (input.name.text == each.name.text && (isTruth(input) || variableOf(input) != kNobody))
        script.parameters[&each] = {skill, slotOf(input)};
  }

  static bool isTruth(const syntax::Input& input) { return input.type.text == "bool"; }

  int variableOf(const syntax::Input& input) {
    return isTruth(input) ? kNobody : script.variable(input.type.text);
  }

  int slotOf(const syntax::Input& input) {
    auto& kept = script.skills[skill].inputs;
    const auto found = std::ranges::find(kept, input.name.text, &InputEntry::name);
    if (found != kept.end()) return static_cast<int>(found - kept.begin());
    kept.push_back({input.name.text, variableOf(input)});
    return static_cast<int>(kept.size()) - 1;
  }

  Script& script;
  int skill;
};

} // namespace

void findInputs(Script& script) {
  for (int skill = 0; skill < static_cast<int>(script.skills.size()); ++skill)
    Finder(script, skill).find();
}

} // namespace proskill::meaning
