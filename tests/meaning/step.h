#pragma once

#include "tests/meaning/steps.h"

namespace proskill::meaning {

/// Builds a step: each function changes the situation after it, and records facts.
class Change {
public:
  Change(const Script& of, const Situation& before, When when)
      : script(of), step{when, {}, before} {}

  void note(What what, int subject, std::uint32_t at = 0) {
    step.facts.push_back({what, subject, at});
  }
  void setEffects(const syntax::Effects& effects);

  // --- Calls

  /// \param given the arguments, as far as conditions or effects depend on them
  void call(int skill, int caller, std::vector<std::int64_t> given = {});
  /// The skill is as before the call, and its caller continues.
  void returnFrom(int skill);
  /// A caller notices the end of its call.
  void seeReturn(int skill, int thread);
  void askToStop(int skill, int thread);

  // --- Skills

  void startSkill(int skill);
  void refuse(int skill);
  void stopBeforeStart(int skill);
  void endSkill(int skill, const Ending& ending);

  // --- Threads

  void goTo(int thread, int place, Control control = Control::Before);
  void wait(int thread, Control control) { goTo(thread, after().threads[thread].place, control); }
  void endBranch(int thread);
  /// It has won its race, if it is in one: the others have to stop.
  void stopRivals(int thread);
  /// Asks the thread's callees to stop, and records what follows.
  void strike(int thread, const Ending& ending);

  [[nodiscard]] Situation& after() { return step.after; }
  [[nodiscard]] Step take() { return std::move(step); }

private:
  SkillState& state(int skill) { return step.after.skills[skill]; }
  void changeResources(int skill, int by);
  void noteDuration(int skill);
  void tellCallers(int thread, int skill, const Outcome& outcome);
  Age& ageOf(int skill) { return step.after.ages[script.threads.size() + skill]; }

  const Script& script;
  Step step;
};

} // namespace proskill::meaning
