#include "codegen/process/basic_skill.h"

#include "codegen/process/executed_action.h"
#include "codegen/process/runtime_action.h"
#include "codegen/process/skill_frame.h"

namespace proskill::codegen {
namespace {

using fiacre::Statement;

class BasicSkill {
public:
  BasicSkill(Context& context, const SkillPlan& skill)
      : context(context), skill(skill), frame(context, skill) {}

  fiacre::Process make() {
    fiacre::Process process;
    process.name = context.names.process({"skill", skill.name()});
    process.origin = frame.place();
    process.comment = context.definitionOf(*skill.definition);
    if (context.isRuntime())
      RuntimeAction(context, skill, frame).addTo(process);
    else if (context.isExecuted() || context.options.separateStops)
      ExecutedAction(context, skill, frame).addTo(process);
    else
      addVerified(process);
    return process;
  }

private:
  void addVerified(fiacre::Process& process) {
    const std::string run = context.isExpanded() ? "action" : "run";
    frame.addStart(process, run);
    auto body = context.isExpanded()
                    ? select(alternatives())
                    : sequence({select(alternatives()), frame.giveBack(), to("idle")});
    addState(process, run, frame.place(), std::move(body), actionText());
    frame.addRest(process);
  }

  /// In the compact edition all endings share the statements after the `select`.
  Statement finish(const Ending& ending) {
    return context.isExpanded() ? frame.end(ending) : frame.outcome(ending);
  }

  std::vector<Statement> alternatives() {
    const auto& node = skill.skill();
    const auto duration =
        node.timeInterval ? context.times.interval(*node.timeInterval) : fiacre::Interval{};
    std::vector<Statement> all;
    for (const auto& outcome : outcomesOf(skill))
      all.push_back(sequence({wait(duration), finish(outcome)}));
    if (node.interrupt)
      all.push_back(sequence({synchronise(context.names.interruptPort(skill.name())),
                              finish(outsideInterruptionOf(skill))}));
    if (skill.obeysStops())
      all.push_back(sequence({atOnce(), on(frame.stop()), finish(interruptionOf(skill))}));
    for (const auto& invariant : node.invariants)
      all.push_back(sequence({atOnce(), on(frame.fails(invariant)), finish(failureOf(invariant))}));
    return all;
  }

  std::string actionText() {
    const auto& action = skill.skill().action;
    return action ? "Action: " + context.origins.excerpt(skill.file(), action->range) : "";
  }

  Context& context;
  const SkillPlan& skill;
  SkillFrame frame;
};

} // namespace

fiacre::Process basicSkill(Context& context, const SkillPlan& skill) {
  return BasicSkill(context, skill).make();
}

} // namespace proskill::codegen
