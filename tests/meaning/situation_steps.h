#pragma once

#include "tests/meaning/endings.h"
#include "tests/meaning/step.h"
#include "tests/meaning/steps.h"

namespace proskill::meaning {

using syntax::Statement;
using syntax::StatementKind;

/// All possible steps in a situation.
class Steps {
public:
  Steps(const Script& of, const Situation& at) : script(of), now(at), look(of, at) {}

  std::vector<Step> find();

private:
  [[nodiscard]] Change change(When when = When::now()) const { return {script, now, when}; }
  void add(Change made) { all.push_back(made.take()); }

  // --- Skills
  void ofSkill(int skill);
  void ofCalled(int skill);
  void ofEnded(int skill);
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> valuesOf(const InputEntry& input) const;
  [[nodiscard]] std::vector<std::vector<std::int64_t>> anyArguments(int skill) const;
  [[nodiscard]] bool resourcesAreFree(int skill) const;
  void ofRunning(int skill);
  void end(int skill, const Ending& ending, When when);
  [[nodiscard]] When within(const syntax::Interval& seconds, int clock) const;

  // --- Threads
  void ofThread(int thread);
  /// Time passes whatever the guards say.
  [[nodiscard]] bool waitsForTime(int thread) const { return now.ages[thread].counts; }

  /// A body whose guard is false takes no further step.
  [[nodiscard]] bool mayGoOn(int thread) const;
  [[nodiscard]] bool hasLost(int thread) const;
  [[nodiscard]] bool isInRace(int thread) const;
  /// Control is at a place where time can pass.
  [[nodiscard]] bool isWaiting(int thread) const;
  void ofCalledBranch(int thread);
  /// No callee is left running.
  void ofStopping(int thread);
  [[nodiscard]] bool isOutstanding(int callee, int thread) const;
  void strike(int thread, const Ending& ending);
  void ofStop(int thread);
  void ofGuards(int thread);

  // statement_steps.cpp
  void ofStatement(int thread, const Place& place);
  void go(int thread, int target, const syntax::Effects* effects = nullptr,
          When when = When::now());
  [[nodiscard]] int armOf(int thread, const Place& place) const;
  void ofBodyEnd(int thread);
  /// The first branch that ends the skill determines the outcome.
  void ofOutcome(int thread, const Statement& statement);
  void ofFork(int thread, const Place& place);
  void ofJoin(int thread, const Place& place);

  // --- Calls
  [[nodiscard]] bool isFree(int callee) const { return now.skills[callee].caller == kNobody; }

  void ofNewCall(int thread, const Place& place);
  void ofBusy(int thread, const Place& place);
  void takeCall(int thread, const Place& place);
  [[nodiscard]] std::vector<std::int64_t> argumentsOf(const Statement& call) const;
  void ofCall(int thread, const Place& place);
  [[nodiscard]] static int armFor(const Outcome& outcome, const Place& place);
  [[nodiscard]] bool isCalledOrRuns(int skill) const;
  void ofInterrupt(int thread, const Place& place);

  // --- The world
  void ofEmit(int thread, const Place& place);
  void occur(Change& made, int event) const;
  /// Whether the event has no `:guard`, or a guard that holds.
  [[nodiscard]] bool mayOccur(int event) const;
  /// Without an environment of its own, everything may happen at any time.
  void ofEvents();
  void ofTheWorld();
  /// A composite skill notices an interrupt from outside while it waits.
  [[nodiscard]] bool takesInterrupts(int skill) const;
  void interruptFromOutside(int skill, When when, int thread, int next);
  /// Once the mission has ended, the program may idle for ever.
  void ofTheEnd();

  const Script& script;
  const Situation& now;
  Look look;
  std::vector<Step> all;
};

} // namespace proskill::meaning
