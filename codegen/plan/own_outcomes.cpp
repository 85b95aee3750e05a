#include "codegen/plan/own_outcomes.h"

#include "codegen/plan/plan.h"
#include "codegen/plan/walk_expressions.h"

namespace proskill::codegen {

using syntax::StatementKind;

OwnOutcomes::OwnOutcomes(const GenerationPlan& plan) {
  for (const auto& skill : plan.skills)
    if (skill.body) noteCalls(*skill.body, {}, plan);
  for (const auto& skill : plan.skills)
    if (skill.body)
      forEachThread(*skill.body, [&](const BodyAutomaton& thread) { noteReads(thread); });
}

void OwnOutcomes::noteCalls(const BodyAutomaton& thread, std::string_view parent,
                            const GenerationPlan& plan) {
  parentOf[thread.name] = parent;
  for (const auto& state : thread.states) {
    for (const auto& branch : state.branches) noteCalls(branch, thread.name, plan);
    if (!state.statement || state.statement->kind != StatementKind::Call) continue;
    const auto callee = state.statement->head.text;
    if (!plan.find(callee)->shared()) continue;
    for (std::string_view at = thread.name; !at.empty(); at = parentOf[at])
      callers.try_emplace({at, callee});
  }
}

void OwnOutcomes::noteReads(const BodyAutomaton& thread) {
  for (const auto& state : thread.states) {
    if (!state.statement) continue;
    noteReads(thread.name, state.statement->condition);
    for (const auto& arm : state.statement->arms)
      if (arm.condition) noteReads(thread.name, *arm.condition);
  }
}

void OwnOutcomes::noteReads(std::string_view thread, const syntax::Expr& condition) {
  forEachPart(condition, [&](const syntax::Expr& part) {
    if (part.kind != syntax::ExprKind::Access) return;
    const auto owner = ownerFor(thread, part.name.text);
    if (owner.empty()) return;
    auto& read = kept[{owner, part.name.text}];
    (part.member.text == "res" ? read.result : read.status) = true;
  });
}

std::string_view OwnOutcomes::ownerFor(std::string_view reader, std::string_view skill) const {
  for (auto at = reader; !at.empty();) {
    if (const auto found = callers.find({at, skill}); found != callers.end())
      return found->first.first;
    const auto parent = parentOf.find(at);
    at = parent == parentOf.end() ? std::string_view{} : parent->second;
  }
  return {};
}

std::vector<std::string_view> OwnOutcomes::toldBy(std::string_view caller,
                                                  std::string_view skill) const {
  std::vector<std::string_view> told;
  for (auto at = caller; !at.empty(); at = parentOf.at(at))
    if (kept.contains({at, skill})) told.push_back(at);
  return told;
}

} // namespace proskill::codegen
