#pragma once

#include "codegen/process/skill_frame.h"

#include <string>
#include <vector>

namespace proskill::codegen {

/// A basic skill as it is executed: the compact one, but its action ends when a port says so, and a
/// skill that breaks it off waits in a state `stopping_…` until it has ended.
class ExecutedAction {
public:
  ExecutedAction(Context& context, const SkillPlan& skill, SkillFrame& frame);

  void addTo(fiacre::Process& process);

private:
  [[nodiscard]] std::vector<fiacre::Statement> results();
  [[nodiscard]] std::vector<fiacre::Statement> breaks();
  [[nodiscard]] fiacre::Statement breakOff(fiacre::Statement trigger, const std::string& reason,
                                           const Ending& ending);

  Context& context;
  const SkillPlan& skill;
  SkillFrame& frame;
  Performed made;
  std::vector<std::pair<std::string, Ending>> stopping; ///< states, and how the skill ends there
};

/// What an executor has to know of a model, beside its tree. \pre the model's tree was built
void tellExecutor(Context& context, Model& model);

} // namespace proskill::codegen
