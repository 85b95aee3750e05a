#pragma once

#include "codegen/model.h"
#include "codegen/plan/body_automaton.h"
#include "codegen/plan/own_outcomes.h"

#include <deque>
#include <expected>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace proskill::codegen {

/// A skill of the model, and the features that its process needs.
struct SkillPlan {
  const analysis::Definition<syntax::Skill>* definition = nullptr;
  std::optional<BodyAutomaton> body;  ///< of a composite skill
  bool root = false;                  ///< called at time 0
  bool generalCaller = false;         ///< the most general caller calls it
  std::set<std::string_view> callers; ///< the skills, branches and environments that call it
  bool mayBeInterrupted = false;      ///< a statement may set its `stop` while it runs
  bool callerMayStop = false;         ///< its caller may set its `stop`, also before it runs
  bool branchEnds = false;   ///< one of its branches contains `(success …)` or `(failure …)`
  bool resultIsRead = false; ///< some condition reads `.res`
  /// Those that conditions or effects read, its own or those of skills to which it passes them.
  std::vector<const syntax::Input*> inputs;
  bool isMeasured = false;   ///< the executor checks its time interval
  bool callsHoldOut = false; ///< an early end may have to wait for its calls

  [[nodiscard]] const syntax::Skill& skill() const { return definition->node(); }
  [[nodiscard]] std::string_view name() const { return skill().name.text; }
  [[nodiscard]] syntax::FileId file() const { return definition->file; }
  [[nodiscard]] bool calledBySkills() const { return !callers.empty(); }
  /// Whether something may set its `stop`.
  [[nodiscard]] bool mayBeStopped() const { return mayBeInterrupted || callerMayStop; }
  /// Whether it also reads `stop` while it runs. Otherwise only a call that still waits can be
  /// stopped.
  [[nodiscard]] bool obeysStops() const { return mayBeStopped() && !skill().unstoppable; }
  /// Whether it must notice that it ends early: from then on its guards do not matter, and its end
  /// may take time.
  [[nodiscard]] bool mayLinger() const { return callsHoldOut && !skill().invariants.empty(); }
  /// Whether nobody else calls it: it starts with the program.
  [[nodiscard]] bool startsItself() const { return root && callers.empty(); }
  /// Whether it waits for its precondition again after each end.
  [[nodiscard]] bool rearms() const {
    return startsItself() && skill().armed && !skill().preconditions.empty();
  }
  /// Whether it runs exactly once.
  [[nodiscard]] bool runsOnce() const { return startsItself() && !rearms(); }
  /// Whether several processes call it, so that a call may find it busy.
  [[nodiscard]] bool shared() const {
    return callers.size() + (root || generalCaller ? 1U : 0U) > 1;
  }
  /// Whether it has a watchdog.
  [[nodiscard]] bool isWatched() const { return body && skill().timeInterval && !isMeasured; }
  /// Whether its watchdog must distinguish one run from the next.
  [[nodiscard]] bool isWatchedAgain() const { return isWatched() && !runsOnce(); }
  /// Whether something may end it before its body ends.
  [[nodiscard]] bool mayStrike() const {
    return obeysStops() || skill().interrupt || !skill().invariants.empty();
  }
  /// Whether something may end the thread, itself or one of its branches, before its end.
  [[nodiscard]] bool mayStrike(const BodyAutomaton& thread) const {
    return mayStrike() || (!thread.path.empty() && (branchEnds || !thread.racers.empty()));
  }
};

/// The skills of the model, and who calls whom.
struct GenerationPlan {
  /// Basic skills, then composite skills, each in the order of the text.
  std::deque<SkillPlan> skills;
  const SkillPlan* mission = nullptr; ///< null: a library of skills
  const analysis::Definition<syntax::Environment>* environment =
      nullptr; ///< null: the most general environment
  std::optional<BodyAutomaton> environmentBody;
  OwnOutcomes ownOutcomes;
  /// Skills and branches that may continue for a while after a request to stop.
  std::set<std::string_view> holdOuts;

  [[nodiscard]] const SkillPlan* find(std::string_view name) const;
  [[nodiscard]] bool hasGeneralCaller() const;
};

/// Selects the skills of the model: all basic skills, and the composite skills that the mission or
/// a monitor calls, directly or indirectly. Skills that only another candidate for the mission
/// calls are skipped.
[[nodiscard]] std::expected<GenerationPlan, GenerationError>
makeGenerationPlan(const analysis::Program& program, const Options& options);

} // namespace proskill::codegen
