#pragma once

#include "tests/meaning/script.h"

#include <compare>

namespace proskill::meaning {

enum class Phase : std::uint8_t {
  Idle,
  Called, ///< not yet started
  Running,
  Returned, ///< a shared skill has ended, and its caller has not yet noticed
  Ended,    ///< it has run, and nobody calls it
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
  bool stop = false;               ///< it was asked to stop
  bool endedEarly = false;         ///< and no time has passed since
  std::vector<std::int64_t> given; ///< the arguments of the current call
  friend auto operator<=>(const SkillState&, const SkillState&) = default;
};

enum class Control : std::uint8_t {
  Off,
  Called,   ///< a branch that has not started
  Before,   ///< a statement
  Busy,     ///< a call whose skill is busy
  Within,   ///< a call or a `//`: waits for the end
  Stopping, ///< waits for its callees to end
};

/// How a skill or a branch is to end.
struct Ending {
  Outcome outcome;
  const syntax::Effects* effects = nullptr;
  const syntax::Expr* postcondition = nullptr;
  std::uint32_t at = 0;              ///< its declaration in the program
  std::uint32_t postconditionAt = 0; ///< its postcondition
  friend auto operator<=>(const Ending&, const Ending&) = default;
};

struct ThreadState {
  Control control = Control::Off;
  int place = 0;
  bool stop = false;  ///< a branch: asked to stop
  Ending ending;      ///< Stopping: what follows
  bool waits = false; ///< Stopping: for the call or the branches of its place
  friend auto operator<=>(const ThreadState&, const ThreadState&) = default;
};

/// An age: integer units and a remainder, as the clock counts them. Ages beyond every bound are not
/// distinguished.
struct Age {
  bool counts = false;
  bool beyond = false;
  std::int64_t whole = 0;
  std::int64_t fraction = 0;
  friend auto operator<=>(const Age&, const Age&) = default;
};

/// The complete state at a moment.
struct Situation {
  std::vector<std::int64_t> values; ///< of state variables; for an enumeration, the index of its
                                    ///< state
  std::vector<int> used;            ///< of each resource
  std::vector<SkillState> skills;
  std::vector<ThreadState> threads;
  std::vector<std::optional<Ending>> decided; ///< by skill: the ending that a branch has chosen
  std::map<std::pair<int, int>, Outcome> own; ///< by thread and skill: the last call's outcome
  std::vector<Age> ages; ///< of threads' statements, skills' runs, events with `:every`
  friend auto operator<=>(const Situation&, const Situation&) = default;
};

} // namespace proskill::meaning
