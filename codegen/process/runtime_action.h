#pragma once

#include "codegen/process/skill_frame.h"

#include <map>
#include <string>

namespace proskill::codegen {

/// A basic skill at runtime: its action is a task of C, which is watched for its time interval, and
/// which an interrupt or a failed invariant tells to stop.
class RuntimeAction {
public:
  RuntimeAction(Context& context, const SkillPlan& skill, SkillFrame& frame);

  void addTo(fiacre::Process& process);

private:
  void addDispatch(fiacre::Process& process);
  [[nodiscard]] std::vector<fiacre::Statement> alternatives();
  [[nodiscard]] fiacre::Statement returned();
  void addTiming(std::vector<fiacre::Statement>& all);
  [[nodiscard]] fiacre::Statement breakOff(const Ending& ending);
  void addStopping(fiacre::Process& process);
  [[nodiscard]] fiacre::Statement awaitTask();

  Context& context;
  const SkillPlan& skill;
  SkillFrame& frame;
  std::string task;
  std::map<std::string, Ending> stopping; ///< states in which the task is awaited, and why
  std::optional<std::int64_t> least; ///< ticks that the action takes at least, where that is told
  std::optional<std::int64_t> late;  ///< the tick at which it has taken too long
};

/// The tasks and functions of C that the model calls.
void declareActions(Context& context, fiacre::Program& program);

} // namespace proskill::codegen
