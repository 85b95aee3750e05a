#include "codegen/process/skill_frame.h"

#include <algorithm>

namespace proskill::codegen {
namespace {

Ending ending(std::string status, const syntax::Outcome& outcome, std::string_view verb) {
  Ending result;
  result.status = std::move(status);
  result.tag = outcome.tag;
  result.effects = &outcome.effects;
  if (outcome.postcondition) result.postcondition = &*outcome.postcondition;
  result.range = outcome.range;
  result.description = verb;
  if (outcome.tag) result.description += " with `" + std::string(outcome.tag.text) + "`";
  return result;
}

Ending untaggedSuccess(const SkillPlan& skill) {
  Ending result;
  result.status = "success";
  result.range = skill.skill().name.range;
  result.description = "succeeds";
  return result;
}

const syntax::Outcome* findOutcome(const syntax::List<syntax::Outcome>& outcomes,
                                   std::string_view tag) {
  const auto found =
      std::ranges::find_if(outcomes, [&](const auto& outcome) { return outcome.tag.text == tag; });
  return found == outcomes.end() ? nullptr : &*found;
}

} // namespace

Ending successOf(const SkillPlan& skill, std::string_view tag) {
  const auto* outcome = findOutcome(skill.skill().successes, tag);
  return outcome ? ending("success", *outcome, "succeeds") : untaggedSuccess(skill);
}

Ending failureOf(const SkillPlan& skill, std::string_view tag) {
  return ending("failure", *findOutcome(skill.skill().failures, tag), "fails");
}

Ending interruptionOf(const SkillPlan& skill) {
  Ending result;
  result.status = "interrupted";
  result.range = skill.skill().name.range;
  result.description = "is interrupted";
  if (const auto& interrupt = skill.skill().interrupt) {
    result.effects = &interrupt->effects;
    result.range = interrupt->range;
  }
  return result;
}

Ending outsideInterruptionOf(const SkillPlan& skill) {
  auto result = interruptionOf(skill);
  result.description = "is interrupted from outside";
  return result;
}

Ending failureOf(const syntax::Invariant& invariant) {
  Ending result;
  result.status = "failed_inv";
  result.tag = invariant.tag;
  result.effects = &invariant.effects;
  result.range = invariant.range;
  result.description = "finds its invariant `" + std::string(invariant.tag.text) + "` violated";
  return result;
}

std::vector<Ending> outcomesOf(const SkillPlan& skill) {
  std::vector<Ending> result;
  const auto& node = skill.skill();
  for (const auto& outcome : node.successes)
    result.push_back(ending("success", outcome, "succeeds"));
  if (result.empty() && !node.isComposite()) result.push_back(untaggedSuccess(skill));
  for (const auto& outcome : node.failures) result.push_back(ending("failure", outcome, "fails"));
  return result;
}

} // namespace proskill::codegen
