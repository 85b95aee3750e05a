#pragma once

#include "analysis/program/program.h"
#include "codegen/model.h"
#include "runtime/machine/monitored.h"
#include "verify/model/system.h"
#include "verify/state/enabled.h"

#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A program in executable form: the transition system of its model's edition `Executed`, and how
/// the executor handles each transition.
namespace proskill::runtime {

/// Time since the start of a run, or a duration.
using Nanoseconds = std::int64_t;

inline constexpr Nanoseconds kSecond = 1'000'000'000;

/// A closed interval in nanoseconds.
struct Span {
  Nanoseconds first = 0;
  std::optional<Nanoseconds> last; ///< nullopt: unbounded
};

/// When a step is taken that must not be taken at its lower bound: a millisecond later, or after
/// half of the interval where that is less. After one nanosecond, a loop that waits `]0,2]` would
/// take a thousand million steps a second.
/// \param last the upper bound
[[nodiscard]] Nanoseconds soonAfter(Nanoseconds bound, const std::optional<Nanoseconds>& last);

/// A basic skill.
struct Action {
  verify::InstanceId instance = 0;
  verify::CellId number = 0; ///< the number of the current arguments
  std::int64_t idle = 0;     ///< idle, run: locations of its process
  std::int64_t run = 0;
  std::vector<std::uint32_t> resultPorts; ///< by codegen::Performed::results
  std::uint32_t unknownPort = verify::kNone;
  std::uint32_t stoppedPort = verify::kNone;
  Span span;
  /// By the number of its arguments: index into Model::actionCalls.
  std::vector<std::size_t> calls;
};

/// A composite skill whose duration is measured.
struct Stretch {
  verify::InstanceId instance = 0;
  std::int64_t idle = verify::kNone; ///< idle, ended: locations in which it does not run
  std::int64_t ended = verify::kNone;
  Span span;
};

enum class Role : std::uint8_t {
  Urgent,   ///< is taken as soon as possible
  Timed,    ///< of the program: is taken as early as possible, but once at a date
  Drawn,    ///< of the environment or the general caller: the date is drawn from the interval
  External, ///< is taken when the platform reports it
};

/// How the executor handles a transition.
struct Handling {
  Role role = Role::Urgent;
  Span span;                            ///< Timed, Drawn: time since it was enabled
  std::uint32_t action = verify::kNone; ///< the action whose process it moves
  std::uint32_t stretch = verify::kNone;
};

/// A part of a message that a body prints: see codegen::MessagePart.
struct MessagePart {
  struct Term {
    std::int64_t factor = 1;
    std::uint32_t watched = 0; ///< index into System::watched
  };
  std::string text; ///< if there are no terms
  std::vector<Term> terms;
  std::int64_t constant = 0;
  bool isValue = false;
};

struct Executable {
  codegen::Model model;
  verify::System system;
  std::optional<verify::Enabling> enabling; ///< enabled transitions; set once the rest is complete
  Nanoseconds unit = 0;                     ///< a unit of the model's time
  std::vector<Action> actions;              ///< by Model::performed
  std::vector<Stretch> stretches;           ///< by Model::measured
  std::vector<std::uint32_t> signalPorts;   ///< by Model::signals
  std::vector<std::optional<Span>> everySpans; ///< by Model::signals; nullopt: not measured
  std::vector<Handling> handling;              ///< by transition
  std::vector<std::vector<verify::TransitionId>> atPort; ///< external transitions, by port
  std::vector<bool> isAlarm;                             ///< by origin
  /// The mission's process and the location in which it has ended; kNone if there is no mission.
  verify::InstanceId mission = verify::kNone;
  std::int64_t missionEnded = 0;
  /// Number of watched variables that users see; the rest are numbers of arguments.
  std::size_t shownVariables = 0;
  std::map<fiacre::OriginId, std::vector<MessagePart>> messages;
  std::vector<Monitored> properties; ///< the program's own, which a run decides

  /// The call that a started action makes. \pre the state contains the number of its arguments
  [[nodiscard]] const codegen::ActionCall* callOf(std::uint32_t action,
                                                  const verify::Word* state) const;
};

/// Why a program cannot be executed, with a place if there is one.
using NotExecutable = codegen::GenerationError;

/// \param environment whether the environment that the program declares is executed, too
/// \pre the program has no errors
[[nodiscard]] std::expected<std::unique_ptr<const Executable>, NotExecutable>
makeExecutable(const analysis::Program& program, const std::string& mainSkill, bool environment);

} // namespace proskill::runtime
