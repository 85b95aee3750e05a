#include "runtime/machine/monitored.h"

#include "fiacre/syntax/formula.h"

namespace proskill::runtime {

using fiacre::PatternKind;
using verify::GoalKind;

namespace {

bool isFormula(const codegen::Model& model, const codegen::Check& check) {
  return model.fiacre.properties[check.property].pattern.kind == PatternKind::Ltl;
}

verify::Goal notExecuted() {
  return {.kind = GoalKind::Unsupported,
          .reason = "it is about the environment, which is not executed"};
}

} // namespace

std::string_view toString(Verdict verdict) {
  switch (verdict) {
  case Verdict::NotYet: return "not yet";
  case Verdict::True: return "true";
  case Verdict::False: return "false";
  }
  return "";
}

std::vector<verify::Question> addNegations(codegen::Model& model) {
  std::vector<verify::Question> questions;
  for (const auto& check : model.checks) questions.push_back({check.property});
  for (const auto& check : model.checks) {
    if (!isFormula(model, check)) continue;
    questions.push_back({model.fiacre.properties.size()});
    auto contrary = model.fiacre.properties[check.property];
    contrary.pattern.ltl = fiacre::negated(std::move(contrary.pattern.ltl));
    model.fiacre.properties.push_back(std::move(contrary));
  }
  return questions;
}

std::vector<Monitored> monitored(const codegen::Model& model,
                                 const std::vector<verify::Goal>& goals) {
  std::vector<Monitored> all;
  auto next = model.checks.size();
  for (std::size_t i = 0; i < model.checks.size(); ++i) {
    const auto& check = model.checks[i];
    auto& made =
        all.emplace_back(Monitored{.check = i,
                                   .goal = goals[i],
                                   .negated = {},
                                   .isGood = check.good == codegen::Expectation::Reachable});
    if (isFormula(model, check)) {
      made.negated = goals[next++];
      if (made.negated->kind == GoalKind::Unsupported) made.goal = *made.negated;
    }
    if (!check.isExecuted) made.goal = notExecuted();
  }
  return all;
}

std::string whyNotMonitored(const Monitored& property) {
  switch (property.goal.kind) {
  case GoalKind::Events:
  case GoalKind::Condition:
  case GoalKind::Run: return "";
  case GoalKind::Longest:
  case GoalKind::Shortest: return "it asks for a time in all runs, not about one run";
  case GoalKind::Deadlock:
  case GoalKind::Stuck:
  case GoalKind::Lost:
  case GoalKind::Error: return "it is about what can happen, not about one run";
  case GoalKind::Unsupported: return property.goal.reason;
  }
  return "";
}

} // namespace proskill::runtime
