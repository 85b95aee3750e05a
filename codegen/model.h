#pragma once

#include "analysis/program/program.h"
#include "fiacre/syntax/tree.h"

#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace proskill::codegen {

/// Tina: the expanded edition in the types of frac, without what frac may refuse. Executed: the
/// compact edition, with actions that somebody performs (docs/runtime.md).
enum class Edition : std::uint8_t { Compact, Expanded, Tina, Runtime, Executed };

/// Exact: a forbidden move is seen in the transition that makes it. Paper: the automaton polls the
/// variable.
enum class StateVariableAutomata : std::uint8_t { Exact, Paper };

struct Options {
  Edition edition = Edition::Compact;
  StateVariableAutomata automata = StateVariableAutomata::Exact;
  std::string mainSkill; ///< empty: the one that no other skill calls
  /// The program's own properties that do not say `:fair` are about fair runs: verify::Question.
  bool fairRuns = true;
  std::int64_t ticksPerSecond = 100; ///< of the runtime edition
  /// Executed: what the program says of its environment is part of the model, as is the most
  /// general caller; else events and interrupts from outside are reported by somebody.
  bool environment = false;
};

/// When a verdict is good news.
enum class Expectation : std::uint8_t { Holds, Reachable };

/// How bad the other verdict is.
enum class Weight : std::uint8_t { Error, Warning };

/// A default property, or one of the program's own, as a question to the model.
struct Check {
  std::string name;                  ///< unique and stable: `takeoff.can_succeed.at_altitude`
  std::string kind;                  ///< `can_succeed`; `property` for the program's own
  std::string subject;               ///< `takeoff`
  std::string description;           ///< "`takeoff` can succeed with `at_altitude`"
  std::vector<std::string> operands; ///< of the program's own pattern, as written
  Expectation good = Expectation::Holds;
  Weight weight = Weight::Error;
  bool fair = false;        ///< it is about fair runs without end
  std::size_t property = 0; ///< index into the model's properties
  fiacre::OriginId origin = 0;
};

/// Runtime: what a basic skill asks of the platform when its `ArgIndex` is `number`.
struct ActionCall {
  std::string skill;
  std::int64_t number = 0;
  std::string command;                ///< of `:action`
  std::vector<std::string> arguments; ///< literals as written; empty where nothing was given
  friend bool operator==(const ActionCall&, const ActionCall&) = default;
};

/// Executed: a basic skill, as whoever performs its action has to know it.
struct Performed {
  /// How the action may end, and the port that says so.
  struct Result {
    std::string status; ///< `success` or `failure`
    std::string tag;    ///< empty where it has none
    std::string port;
  };
  std::string skill;
  std::string process;
  std::string numberCell; ///< the lvalue that has the number of its ActionCall
  std::vector<Result> results;
  std::string unknownPort;                  ///< its action ended, and not by one of the results
  std::string stoppedPort;                  ///< its action ended after it was asked to stop
  std::optional<fiacre::Interval> interval; ///< how long its action takes, in units
  fiacre::OriginId intervalOrigin = 0;
};

/// Executed: a composite skill whose run is measured.
struct Measured {
  std::string skill;
  std::string process;
  fiacre::Interval interval; ///< in units
  fiacre::OriginId origin = 0;
};

/// Executed: an event, or an interrupt from outside.
struct Signal {
  std::string name; ///< of the event or of the skill
  bool interrupts = false;
  std::string port;
  /// Of an event, between two occurrences and from the start to the first, in units.
  std::optional<fiacre::Interval> every;
  fiacre::OriginId everyOrigin = 0;
};

/// Executed: what is wrong where a step passes an origin.
enum class Alarm : std::uint8_t {
  ForbiddenMove,
  FailedInvariant,
  FailedPostcondition,
  UnknownResult,
};

/// A program's meaning. `unit` of time: one step of the model is numerator/denominator seconds.
struct Model {
  fiacre::Program fiacre;
  fiacre::Provenance provenance;
  std::vector<Check> checks;
  std::vector<ActionCall> actionCalls; ///< runtime and executed
  std::vector<Performed> performed;
  std::vector<Measured> measured;
  std::vector<Signal> signals; ///< all of the program's, whoever gives them
  std::map<fiacre::OriginId, Alarm> alarms;
  std::string missionProcess; ///< executed; empty where there is no mission
  /// Executed: processes of the environment, whose waits may last as long as they like.
  std::vector<std::string> drawnProcesses;
  bool hasEnvironment = false; ///< executed: the signals come from one of these processes
  /// Processes of actions and delays that have no upper bound. In a fair run each of these ends:
  /// see verify::Question::fair.
  std::map<std::string, std::string> obliged; ///< with what they are to people: "`drive`"
  syntax::Rational unit{1, 1};
  std::string mainSkill; ///< empty where there is none: a library of skills
};

/// Why there is no model, with the place where there is one.
struct GenerationError {
  std::string message;
  analysis::Location location;
};

/// The program's model. \pre the program has no errors.
[[nodiscard]] std::expected<Model, GenerationError> generate(const analysis::Program& program,
                                                             const Options& options = {});

} // namespace proskill::codegen
