#include "viz/builder.h"

namespace proskill::viz {
namespace {

std::vector<std::string> conditions(const Builder& builder, const syntax::Skill& skill) {
  std::vector<std::string> lines;
  for (const auto& each : skill.preconditions)
    lines.push_back(std::string(each.tag.text) + ": " + builder.text(each.condition.range));
  return lines;
}

Exits drawPrecondition(Builder& builder, const SkillDefinition& skill, const Exits& in) {
  if (skill->preconditions.empty()) return in;
  const auto range = span(skill->preconditions);
  if (skill->armed)
    return builder.then(in, builder.node(NodeRole::Wait, "until the precondition holds", range,
                                         conditions(builder, skill.node())));
  const auto test =
      builder.node(NodeRole::Test, "precondition?", range, conditions(builder, skill.node()));
  builder.connect(in, test);
  const auto refused = builder.node(NodeRole::End, "refused", range, {"no_status"});
  builder.edge({test, refused, EdgeRole::No, "no", {}});
  return {{.from = test, .role = EdgeRole::Yes, .label = "yes"}};
}

Exits drawStart(Builder& builder, const SkillDefinition& skill, const Exits& in) {
  auto lines = builder.effects(skill->start);
  for (const auto& resource : skill->resources)
    lines.push_back("takes " + std::string(resource.text));
  if (lines.empty()) return in;
  const auto range = skill->start.items.empty() ? span(skill->resources) : skill->start.range;
  return builder.then(in, builder.node(NodeRole::Step, "start", range, lines));
}

void drawOutcomes(Builder& builder, NodeRole role, const syntax::List<syntax::Outcome>& outcomes,
                  std::size_t run, std::size_t end) {
  for (const auto& outcome : outcomes) {
    const auto node = drawOutcome(builder, role, outcome);
    builder.edge({run, node});
    builder.edge({node, end});
  }
}

/// Draws what ends the skill before its action has ended.
void drawStops(Builder& builder, const SkillDefinition& skill, std::size_t run, std::size_t end) {
  for (const auto& invariant : skill->invariants) {
    auto lines = builder.effects(invariant.effects);
    lines.insert(lines.begin(), "fails: " + builder.text(invariant.guard.range));
    const auto node =
        builder.node(NodeRole::Invariant, std::string(invariant.tag.text), invariant.range, lines);
    builder.edge({run, node, EdgeRole::Stops, {}, {}});
    builder.edge({node, end});
  }
  if (!skill->interrupt) return;
  const auto node = builder.node(NodeRole::Interrupt, "interrupted", skill->interrupt->range,
                                 builder.effects(skill->interrupt->effects));
  builder.edge({run, node, EdgeRole::Stops, {}, {}});
  builder.edge({node, end});
}

std::size_t drawRun(Builder& builder, const SkillDefinition& skill) {
  std::vector<std::string> lines;
  if (skill->action) lines.push_back(builder.text(skill->action->range));
  if (skill->timeInterval) lines.push_back(builder.seconds(*skill->timeInterval));
  if (skill->unstoppable) lines.emplace_back("is never stopped");
  return builder.node(NodeRole::Action, "run",
                      skill->action ? skill->action->range : skill->name.range, lines);
}

} // namespace

Exits drawBeginning(Builder& builder, const SkillDefinition& skill) {
  const auto start = builder.node(NodeRole::Start, {}, skill->name.range);
  return drawStart(builder, skill, drawPrecondition(builder, skill, {{.from = start}}));
}

std::size_t drawOutcome(Builder& builder, NodeRole role, const syntax::Outcome& outcome) {
  auto lines = builder.effects(outcome.effects);
  if (outcome.postcondition) lines.push_back("then " + builder.text(outcome.postcondition->range));
  return builder.node(role, std::string(outcome.tag.text), outcome.range, lines);
}

Graph drawBasicSkill(const analysis::Program& program, const SkillDefinition& skill) {
  Builder builder(program, skill.file);
  builder.graph.title = "skill " + std::string(skill.name());
  const auto in = drawBeginning(builder, skill);
  const auto run = drawRun(builder, skill);
  builder.connect(in, run);
  const auto end = builder.node(NodeRole::End, "returns", skill->name.range);
  drawOutcomes(builder, NodeRole::Success, skill->successes, run, end);
  if (skill->successes.empty()) builder.edge({run, end});
  drawOutcomes(builder, NodeRole::Failure, skill->failures, run, end);
  drawStops(builder, skill, run, end);
  return std::move(builder.graph);
}

} // namespace proskill::viz
