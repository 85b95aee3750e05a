#pragma once

#include "codegen/process/skill_frame.h"

#include <string>
#include <vector>

namespace proskill::codegen {

/// A basic skill in the executed edition: like the compact one, but a port reports the end of its
/// action, and a skill that cancels the action waits in a state `stopping_…` until it has ended.
/// With Options::separateStops it has these states, but the times of the compact edition.
class ExecutedAction {
public:
  ExecutedAction(Context& context, const SkillPlan& skill, SkillFrame& frame);

  void addTo(fiacre::Process& process);

private:
  [[nodiscard]] std::vector<fiacre::Statement> results();
  [[nodiscard]] std::vector<fiacre::Statement> timedResults();
  [[nodiscard]] std::vector<fiacre::Statement> reportedResults();
  [[nodiscard]] std::vector<fiacre::Statement> breaks();
  [[nodiscard]] fiacre::Statement breakOff(fiacre::Statement trigger, const std::string& reason,
                                           const Ending& ending);
  [[nodiscard]] fiacre::Statement stopped();

  Context& context;
  const SkillPlan& skill;
  SkillFrame& frame;
  Performed made;
  std::vector<std::pair<std::string, Ending>> stopping; ///< states, and how the skill ends in them
};

/// The results that the action of a basic skill may have, without their ports.
[[nodiscard]] std::vector<Performed::Result> resultsOf(const SkillPlan& skill);

/// The signals of a program, without their ports and intervals.
[[nodiscard]] std::vector<Signal> signalsOf(const analysis::Program& program,
                                            const GenerationPlan& plan);

/// Fills in what an executor needs besides the model's tree. \pre the tree was built
void tellExecutor(Context& context, Model& model);

} // namespace proskill::codegen
