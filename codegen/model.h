#pragma once

#include "analysis/program/program.h"
#include "fiacre/syntax/tree.h"

#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace proskill::codegen {

/// Compact: as few states as possible. Expanded: every state is named. Tina: the expanded edition
/// with the types that frac accepts, without anything that frac may reject. Runtime: for Hippo.
/// Executed: the compact edition, whose actions a platform performs (docs/runtime.md).
enum class Edition : std::uint8_t { Compact, Expanded, Tina, Runtime, Executed };

/// How automata of state variables notice forbidden moves. Exact: the transition that makes the
/// move raises an alarm. Paper: the automaton polls the variable.
enum class StateVariableAutomata : std::uint8_t { Exact, Paper };

struct Options {
  Edition edition = Edition::Compact;
  StateVariableAutomata automata = StateVariableAutomata::Exact;
  std::string mainSkill; ///< empty: the skill that no other skill calls
  /// The program's own properties without `:fair` are about fair runs: see verify::Question.
  bool fairRuns = true;
  std::int64_t ticksPerSecond = 100; ///< for the runtime edition
  /// Executed: the model includes the program's environment and the most general caller; otherwise
  /// the platform reports events and interrupts from outside.
  bool environment = false;
  /// Compact: an action that is asked to stop ends in a state of its own, as in the executed
  /// edition. This state is left at once.
  bool separateStops = false;
};

/// The verdict that is good news.
enum class Expectation : std::uint8_t { Holds, Reachable };

/// The weight of the other verdict.
enum class Weight : std::uint8_t { Error, Warning };

/// A default property, or a property of the program, as a question about the model.
struct Check {
  std::string name;                  ///< unique and stable: `takeoff.can_succeed.at_altitude`
  std::string kind;                  ///< `can_succeed`; `property` for a property of the program
  std::string subject;               ///< `takeoff`
  std::string description;           ///< "`takeoff` can succeed with `at_altitude`"
  std::vector<std::string> operands; ///< of the pattern of a property of the program, as written
  Expectation good = Expectation::Holds;
  Weight weight = Weight::Error;
  bool fair = false;            ///< only fair infinite runs count
  std::set<std::string> exempt; ///< processes of Model::obliged that need not end in these
  bool rests = false;           ///< not fair: see verify::Question::rests
  std::string note;             ///< what the answer rests on, if it is the good one; may be empty
  /// Executed edition: false if it is about a body that is not executed. Its property means
  /// nothing.
  bool isExecuted = true;
  std::size_t property = 0; ///< index into the model's properties
  fiacre::OriginId origin = 0;
};

/// Runtime: the action that a basic skill requests from the platform when its `ArgIndex` is
/// `number`.
struct ActionCall {
  std::string skill;
  std::int64_t number = 0;
  std::string command;                ///< of `:action`
  std::vector<std::string> arguments; ///< literals as written; empty if no argument was given
  friend bool operator==(const ActionCall&, const ActionCall&) = default;
};

/// Executed: a basic skill, whose action a platform performs.
struct Performed {
  /// An outcome of the action, and the port that reports it.
  struct Result {
    std::string status; ///< `success` or `failure`
    std::string tag;    ///< empty: none
    std::string port;
  };
  std::string skill;
  std::string process;
  std::string numberCell; ///< the lvalue that holds the index of its ActionCall
  std::vector<Result> results;
  std::string unknownPort; ///< the action ended with an outcome that the skill does not declare
  std::string stoppedPort; ///< the action ended after a request to stop
  std::optional<fiacre::Interval> interval; ///< duration of the action, in units
  fiacre::OriginId intervalOrigin = 0;
};

/// Executed: a composite skill whose duration is measured.
struct Measured {
  std::string skill;
  std::string process;
  fiacre::Interval interval; ///< in units
  fiacre::OriginId origin = 0;
};

/// Executed: an event, or an interrupt from outside.
struct Signal {
  std::string name; ///< the event or the skill
  bool interrupts = false;
  std::string port;
  bool guarded = false; ///< an event that occurs only while its `:guard` holds
  /// For an event: the time between two occurrences, and from the start to the first one, in units.
  std::optional<fiacre::Interval> every;
  fiacre::OriginId everyOrigin = 0;
};

/// Executed: a part of a message that a body prints.
struct MessagePart {
  /// A sum of naturals, or the value of one variable.
  struct Term {
    std::int64_t factor = 1;
    std::string variable; ///< as it is shown to users: `battery`, `takeoff.status`
  };
  std::string text; ///< if there are no terms
  std::vector<Term> terms;
  std::int64_t constant = 0;
  bool isValue = false; ///< the first term's variable alone, whatever its type
};

/// Executed: the error that a step through an origin means.
enum class Alarm : std::uint8_t {
  ForbiddenMove,
  FailedInvariant,
  FailedPostcondition,
  UnknownResult,
};

/// A process of which some states end in a fair run.
struct Obliged {
  std::string skill;
  std::string description; ///< "`drive`"
};

/// Executed: what a program expects of its platform.
struct PlatformInterface {
  std::vector<Performed> performed;
  std::vector<Signal> signals; ///< all of the program, whatever causes them
};

/// The meaning of a program. One time unit of the model is numerator/denominator seconds.
struct Model : PlatformInterface {
  fiacre::Program fiacre;
  fiacre::Provenance provenance;
  std::vector<Check> checks;           ///< executed edition: of the program's own properties only
  std::vector<ActionCall> actionCalls; ///< in the runtime and executed editions
  std::vector<Measured> measured;
  std::map<fiacre::OriginId, Alarm> alarms;
  std::map<fiacre::OriginId, std::vector<MessagePart>> messages; ///< executed edition
  std::string missionProcess; ///< executed edition; empty: no mission
  /// Executed: processes of the environment. Their waits have no time limit.
  std::vector<std::string> drawnProcesses;
  bool hasEnvironment = false; ///< executed edition: one of these processes causes the signals
  /// Processes of actions and delays without an upper bound. In a fair run each of these ends: see
  /// verify::Question::fair.
  std::map<std::string, Obliged> obliged;
  /// Not performed: for each skill, in the order of the plan, the condition that it runs.
  std::vector<std::pair<std::string, fiacre::Expr>> running;
  /// Not performed: by index in the model's `skill[]`, the skill or branch as traces call it.
  std::vector<std::string> threads;
  syntax::Rational unit{1, 1};
  std::string beginPort; ///< comes before all else; empty: no initial value is to be chosen
  std::string mainSkill; ///< empty: a library of skills without a mission
};

/// Why a program has no model, with its place if there is one.
struct GenerationError {
  std::string message;
  analysis::Location location;
};

/// The same as in the model, but only with names: without processes, ports and times. Much faster
/// than a model. \pre the program has no errors
[[nodiscard]] std::expected<PlatformInterface, GenerationError>
platformInterface(const analysis::Program& program, const Options& options = {});

/// The model of a program. \pre the program has no errors
/// \throw analysis::Stopped if it is cancelled
[[nodiscard]] std::expected<Model, GenerationError> generate(const analysis::Program& program,
                                                             const Options& options = {});

} // namespace proskill::codegen
