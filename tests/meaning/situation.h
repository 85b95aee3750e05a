#pragma once

#include "tests/meaning/script.h"

#include <compare>

namespace proskill::meaning {

enum class Phase : std::uint8_t {
  Idle,
  Called, ///< and not yet started
  Running,
  Returned, ///< a shared skill is done, and its caller has not yet seen it
  Ended,    ///< it ran once and never runs again
};

enum class Status : std::uint8_t { None, Success, Failure, FailedInvariant, Interrupted };

/// What a caller learns of a call.
struct Outcome {
  Status status = Status::None;
  std::string_view result = "no_result"; ///< the tag
  friend auto operator<=>(const Outcome&, const Outcome&) = default;
};

struct SkillState {
  Phase phase = Phase::Idle;
  int caller = kNobody; ///< a thread, or root
  Outcome last;
  bool stop = false;       ///< it was asked to stop
  bool endedEarly = false; ///< and no time has passed since
  friend auto operator<=>(const SkillState&, const SkillState&) = default;
};

enum class Control : std::uint8_t {
  Off,
  Called,   ///< a branch that has not yet begun
  Before,   ///< a statement
  Busy,     ///< a call whose skill somebody else uses
  Within,   ///< a call or a `//`: waiting for the end
  Stopping, ///< waiting for what it called to be gone
};

/// How a skill, or a branch, is to end.
struct Ending {
  Outcome outcome;
  const syntax::Effects* effects = nullptr;
  const syntax::Expr* postcondition = nullptr;
  std::uint32_t at = 0;              ///< where the program declares it
  std::uint32_t postconditionAt = 0; ///< where its postcondition stands
  friend auto operator<=>(const Ending&, const Ending&) = default;
};

struct ThreadState {
  Control control = Control::Off;
  int place = 0;
  bool stop = false;  ///< a branch: asked to stop
  Ending ending;      ///< Stopping: what comes then
  bool waits = false; ///< Stopping: for the call or the branches of its place
  friend auto operator<=>(const ThreadState&, const ThreadState&) = default;
};

/// How long something has lasted: whole units, and what is beyond them, as the keeper of time
/// counts it. How much longer than every bound it is does not matter.
struct Age {
  bool counts = false;
  bool beyond = false;
  std::int64_t whole = 0;
  std::int64_t fraction = 0;
  friend auto operator<=>(const Age&, const Age&) = default;
};

/// Everything that matters at a moment.
struct Situation {
  std::vector<std::int64_t> values; ///< of state variables; of an enumeration, which of its states
  std::vector<int> used;            ///< of each resource
  std::vector<SkillState> skills;
  std::vector<ThreadState> threads;
  std::vector<std::optional<Ending>> decided; ///< by skill: how a branch has ended it
  std::map<std::pair<int, int>, Outcome> own; ///< of thread and skill: the last call's outcome
  std::vector<Age> ages; ///< of threads' statements, skills' runs, events with `:every`
  friend auto operator<=>(const Situation&, const Situation&) = default;
};

} // namespace proskill::meaning
