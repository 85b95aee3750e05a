#pragma once

#include "codegen/model.h"
#include "codegen/plan/body_automaton.h"
#include "codegen/plan/own_outcomes.h"

#include <deque>
#include <expected>
#include <optional>
#include <set>
#include <string_view>

namespace proskill::codegen {

/// A skill of the model, and what its process has to provide for.
struct SkillPlan {
  const analysis::Definition<syntax::Skill>* definition = nullptr;
  std::optional<BodyAutomaton> body;  ///< of a composite skill
  bool root = false;                  ///< is called at time 0
  bool generalCaller = false;         ///< the most general caller calls it
  std::set<std::string_view> callers; ///< the skills, branches and environments that call it
  bool mayBeInterrupted = false;      ///< a statement may set its `stop` while it runs
  bool callerMayStop = false;         ///< its caller may set its `stop`, before it runs too
  bool branchEnds = false;            ///< a branch of it has a `(success …)` or `(failure …)`
  bool resultIsRead = false;          ///< something reads `.res`
  bool isMeasured = false;            ///< whoever executes it looks at its time interval
  bool callsHoldOut = false;          ///< it may have to wait when it is to end early

  [[nodiscard]] const syntax::Skill& skill() const { return definition->node(); }
  [[nodiscard]] std::string_view name() const { return skill().name.text; }
  [[nodiscard]] syntax::FileId file() const { return definition->file; }
  [[nodiscard]] bool calledBySkills() const { return !callers.empty(); }
  /// Something may set its `stop`.
  [[nodiscard]] bool mayBeStopped() const { return mayBeInterrupted || callerMayStop; }
  /// … and it looks at it while it runs. Else it is only a call that can be stopped.
  [[nodiscard]] bool obeysStops() const { return mayBeStopped() && !skill().unstoppable; }
  /// It is to be told that it ends early, and that its guards do not matter any more: that may take
  /// time.
  [[nodiscard]] bool mayLinger() const { return callsHoldOut && !skill().invariants.empty(); }
  /// It runs once and never again.
  [[nodiscard]] bool runsOnce() const { return root && callers.empty(); }
  /// More than one process calls it, so a call may find it busy.
  [[nodiscard]] bool shared() const {
    return callers.size() + (root || generalCaller ? 1U : 0U) > 1;
  }
  /// It has a watchdog.
  [[nodiscard]] bool isWatched() const { return body && skill().timeInterval && !isMeasured; }
  /// Its watchdog has to tell one run from the next.
  [[nodiscard]] bool isWatchedAgain() const { return isWatched() && !runsOnce(); }
  /// Something may end it before its body has come to an end.
  [[nodiscard]] bool mayStrike() const {
    return obeysStops() || skill().interrupt || !skill().invariants.empty();
  }
  /// Something may end the thread, itself or one of its branches, before it has come to its end.
  [[nodiscard]] bool mayStrike(const BodyAutomaton& thread) const {
    return mayStrike() || (!thread.path.empty() && (branchEnds || !thread.racers.empty()));
  }
};

/// Which skills are in the model, and who calls whom.
struct GenerationPlan {
  std::deque<SkillPlan> skills;       ///< basic ones, then composite ones, in the order of the text
  const SkillPlan* mission = nullptr; ///< null: a library of skills
  const analysis::Definition<syntax::Environment>* environment =
      nullptr; ///< null: the most general
  std::optional<BodyAutomaton> environmentBody;
  OwnOutcomes ownOutcomes;
  std::set<std::string_view> holdOuts; ///< skills and branches that may go on when told to stop

  [[nodiscard]] const SkillPlan* find(std::string_view name) const;
  [[nodiscard]] bool hasGeneralCaller() const;
};

/// Basic skills are all in the model; composite ones where the mission or a monitor calls them,
/// directly or not. What only another candidate for the mission calls is left out.
[[nodiscard]] std::expected<GenerationPlan, GenerationError>
makeGenerationPlan(const analysis::Program& program, const Options& options);

} // namespace proskill::codegen
