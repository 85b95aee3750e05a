#pragma once

#include "fiacre/syntax/tree.h"

#include <atomic>
#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace proskill::verify {

class AnswerStore; ///< verify/answer_store.h

/// A question to a model: one of its properties, by index.
struct Question {
  std::size_t property = 0;
  /// Of a property of runs without end: only fair runs count. A run is fair if time goes on for
  /// ever in it, and no process of Options::obliged stays for ever in a state that it can leave by
  /// itself.
  bool fair = false;
};

/// What is true of the property as it is written: `absent X` is violated where X can be reached.
enum class Truth : std::uint8_t { True, False, Unknown };

/// A variable that a step changed, as a user knows it.
struct Change {
  std::string variable;
  std::string before;
  std::string after;
};

/// A date in units of the model.
struct Date {
  std::int64_t value = 0;
  bool strict = false; ///< not the date itself, but arbitrarily near to it
};

/// What something was decided by: a value, and since when it had been there.
struct Support {
  std::string variable; ///< empty: nothing that a user knows
  std::string value;
  std::size_t since = 0; ///< how many steps had been taken then; 0: from the start
  friend bool operator==(const Support&, const Support&) = default;
};

/// What a ground of an origin came to in a step.
struct GroundValue {
  fiacre::OriginId origin = 0;
  std::uint32_t ground = 0; ///< of the origin
  std::int64_t value = 0;
  std::vector<Support> support; ///< together they suffice
};

/// What a step had to wait for.
struct Timer {
  std::size_t since = 0; ///< how many steps had been taken when it began; 0: the start
  fiacre::Interval interval;
};

/// A step of a witness.
struct Step {
  std::vector<fiacre::OriginId>
      origins; ///< of the statements that were passed, the most descriptive last
  std::vector<std::string> transitions; ///< the Fiacre transitions: `skill_takeoff_1_t3`
  std::vector<std::string> instances;   ///< of processes, that move: `skill_takeoff_1`
  Date earliest;                        ///< since the start, over all runs through these steps
  std::optional<Date> latest;           ///< nothing: unbounded
  std::int64_t date = 0; ///< in the concrete run that was replayed, in units of 1/Trace::scale
  std::vector<Change> changes;
  std::string failure; ///< why the step fails: the run ends with it; empty where it does not
  std::vector<GroundValue> grounds{};
  std::vector<std::size_t> causes{}; ///< steps that it depends on directly, from 0, ascending
  std::optional<Timer> timer{};      ///< of a step that cannot come at once
  bool relevant = true;              ///< to what the trace is a witness of: see trace/causes.h
};

/// What can come behind the last step of a run, or from where its steps repeat.
enum class Rest : std::uint8_t {
  No,      ///< something has to happen, sooner or later; or nobody looked
  Allowed, ///< nothing has to happen any more
  Forced,  ///< nothing is possible any more, or only what changes nothing
};

/// A run from the initial state. It was replayed step by step, with the dates that it gives, before
/// it got here.
struct Trace {
  std::int64_t scale = 1;      ///< `Step::date` is in units of 1/scale of the model's unit
  std::vector<Change> initial; ///< every watched variable's first value, in `after`
  std::vector<Step> steps;
  /// Until when nothing else has to happen for the run to show what it is a witness of, in units of
  /// 1/scale; 0 where the steps do.
  std::int64_t end = 0;
  std::optional<std::size_t> loop; ///< the steps from this one on are repeated for ever
  Rest rest = Rest::No;            ///< of a run that is a witness as a whole
  std::vector<Support> support{};  ///< what the last state shows it by, where that is a condition
  std::vector<fiacre::OriginId> waits{}; ///< where nothing is possible any more: see waitsIn()
};

struct Answer {
  Truth truth = Truth::Unknown;
  std::optional<Trace> trace; ///< the witness of reachability, or of a violation
  std::string reason;         ///< where unknown: which limit was met, or what is not supported
};

/// Measures against the explosion of states; each is its own file, argued sound in
/// docs/verification.md.
enum class Reduction : std::uint8_t {
  DeadVariables, ///< variables that nothing reads, and processes that only watch
  LiveVariables, ///< a variable that is written before it is read again counts as 0
  FreeInputs,    ///< one of the values that the environment may set at any time stands for all
  PrivateMoves,  ///< what a process does on inputs of its own is done at once
  StubbornSets,  ///< one safe urgent step at a time
  Inclusion,     ///< a zone within another of the same marking is not explored
  Extrapolation, ///< bounds beyond the largest constants are forgotten (LU)
};

/// They hold in every phase. What is decided when one is met stays decided.
struct Limits {
  std::optional<double> seconds;
  std::optional<std::uint64_t> bytes; ///< resident, of the whole process
  std::optional<std::uint64_t> classes;
};

struct Progress {
  std::uint64_t classes = 0;
  std::uint64_t markings = 0;
  std::uint64_t waiting = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;
  std::uint64_t decided = 0; ///< questions that have their witness
  std::uint64_t questions = 0;
};

struct Options {
  std::set<Reduction> reductions{Reduction::DeadVariables, Reduction::LiveVariables,
                                 Reduction::FreeInputs,    Reduction::PrivateMoves,
                                 Reduction::StubbornSets,  Reduction::Inclusion,
                                 Reduction::Extrapolation};
  Limits limits;
  unsigned jobs = 1;
  std::set<std::string> obliged; ///< processes; see Question::fair
  const std::atomic<bool>* cancelled = nullptr;
  std::function<void(const Progress&)> progress; ///< called a few times a second
  /// Gets the answer to each question, by its place, as soon as it is decided. Its trace is then
  /// not in the result, so that there is never more than one of it.
  std::function<void(std::size_t, Answer)> decided;
  /// Whether anybody looks at the trace of the answer to a question; empty: at all of them. What
  /// shows the answer is replayed all the same.
  std::function<bool(std::size_t)> wantsTrace;
  std::function<double()> clock;  ///< seconds since some moment; empty: the machine's
  AnswerStore* answers = nullptr; ///< what is known of this model, and gets what is decided
};

/// What was explored.
struct Exploration {
  std::uint64_t classes = 0;
  std::uint64_t markings = 0; ///< discrete states
  std::uint64_t domains = 0;  ///< different zones
  std::uint64_t transitions = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;
  bool complete = false;
  std::string stopped;     ///< which limit, where it is not complete
  std::uint64_t known = 0; ///< questions that Options::answers had the answers to
};

struct Result {
  std::vector<Answer> answers; ///< one a question
  Exploration exploration;
};

/// Why a model cannot be explored: something of Fiacre that the engine does not run.
struct Unsupported {
  std::string message;
  fiacre::OriginId origin = 0;
};

/// Answers all questions by one exploration of the dense-time states. Exact: an answer other than
/// Unknown is never wrong, and Unknown is given only where a limit was met or the property's kind
/// is not supported.
[[nodiscard]] std::expected<Result, Unsupported> verify(const fiacre::Program& program,
                                                        const fiacre::Provenance& provenance,
                                                        const std::vector<Question>& questions,
                                                        const Options& options = {});

/// The graph of state classes with nothing reduced, counted as sift does.
/// Berthomieu and Diaz, "Modeling and verification of time dependent systems using time Petri
/// nets", TSE 1991.
[[nodiscard]] std::expected<Exploration, Unsupported> countClasses(const fiacre::Program& program,
                                                                   const Options& options = {});

} // namespace proskill::verify
