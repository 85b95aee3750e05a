#pragma once

#include "analysis/program/program.h"
#include "codegen/model.h"
#include "verify/model/system.h"
#include "verify/state/enabled.h"

#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A program as it is executed: the transition system of the edition `Executed` of its model, and
/// what its transitions mean to whoever runs it.
namespace proskill::runtime {

/// Time since the start of a run, or a length of it.
using Nanoseconds = std::int64_t;

inline constexpr Nanoseconds kSecond = 1'000'000'000;

/// An interval in whole nanoseconds, both ends included.
struct Span {
  Nanoseconds first = 0;
  std::optional<Nanoseconds> last; ///< nothing: unbounded
};

/// A basic skill.
struct Action {
  verify::InstanceId instance = 0;
  verify::CellId number = 0; ///< of its arguments
  std::int64_t idle = 0;     ///< locations of its process
  std::int64_t run = 0;
  std::vector<std::uint32_t> resultPorts; ///< by the results of codegen::Performed
  std::uint32_t unknownPort = verify::kNone;
  std::uint32_t stoppedPort = verify::kNone;
  Span span;
  /// By the number of its arguments: the place in Model::actionCalls.
  std::vector<std::size_t> calls;
};

/// A composite skill whose run is measured.
struct Stretch {
  verify::InstanceId instance = 0;
  std::int64_t idle = verify::kNone; ///< its locations where it does not run
  std::int64_t ended = verify::kNone;
  Span span;
};

enum class Role : std::uint8_t {
  Urgent,   ///< happens as soon as it can
  Timed,    ///< of the program: at the first moment that it may
  Drawn,    ///< of the environment or the general caller: at some moment of its interval
  External, ///< when somebody says so
};

/// What executing a transition takes.
struct Handling {
  Role role = Role::Urgent;
  Span span;                            ///< Timed, Drawn: since it is enabled
  std::uint32_t action = verify::kNone; ///< it moves this action's process
  std::uint32_t stretch = verify::kNone;
};

struct Executable {
  codegen::Model model;
  verify::System system;
  std::optional<verify::Enabling> enabling;    ///< of the system; there once this is made
  Nanoseconds unit = 0;                        ///< of the model's time
  std::vector<Action> actions;                 ///< by Model::performed
  std::vector<Stretch> stretches;              ///< by Model::measured
  std::vector<std::uint32_t> signalPorts;      ///< by Model::signals
  std::vector<std::optional<Span>> everySpans; ///< by Model::signals, of those that are measured
  std::vector<Handling> handling;              ///< by transition
  std::vector<std::vector<verify::TransitionId>> atPort; ///< those that are external, by port
  std::vector<bool> isAlarm;                             ///< by origin
  /// The mission's process and the location in which it has ended; kNone where there is none.
  verify::InstanceId mission = verify::kNone;
  std::int64_t missionEnded = 0;
  /// Of the watched variables: the others are numbers of arguments.
  std::size_t shownVariables = 0;

  /// The call that a started action makes. \pre state has its number
  [[nodiscard]] const codegen::ActionCall* callOf(std::uint32_t action,
                                                  const verify::Word* state) const;
};

/// Why a program cannot be executed, with the place where there is one.
using NotExecutable = codegen::GenerationError;

/// \param environment whether what the program says of its environment happens by itself
/// \pre the program has no errors
[[nodiscard]] std::expected<std::unique_ptr<const Executable>, NotExecutable>
makeExecutable(const analysis::Program& program, const std::string& mainSkill, bool environment);

} // namespace proskill::runtime
