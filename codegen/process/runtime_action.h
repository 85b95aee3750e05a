#pragma once

#include "codegen/process/skill_frame.h"

#include <map>
#include <string>

namespace proskill::codegen {

/// A basic skill at runtime. Its action is a task in C. The process checks the task's duration and
/// asks it to stop at an interrupt or a failed invariant.
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
  std::map<std::string, Ending> stopping; ///< states that wait for the task's end, and why
  std::optional<std::int64_t> least; ///< minimal duration of the action in ticks, if it is checked
  std::optional<std::int64_t> late;  ///< tick from which the action has taken too long
};

/// The tasks and functions in C that the model calls.
void declareActions(Context& context, fiacre::Program& program);

} // namespace proskill::codegen
