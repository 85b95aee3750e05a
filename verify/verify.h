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

class AnswerStore;     ///< verify/answer_store.h
class CheckpointStore; ///< verify/checkpoint_store.h
class Ranks;           ///< verify/ranks.h
class SpillStore;      ///< verify/spill_store.h

/// A question about a model: one of its properties, by index.
struct Question {
  std::size_t property = 0;
  /// For properties of infinite runs: only fair runs count. A run is fair if time diverges in it
  /// and no process of Options::obliged stays for ever in a state that it can leave by itself.
  bool fair = false;
  std::set<std::string> exempt; ///< of Options::obliged; these may stay for ever
  /// If not only fair runs count: a run may also end where no step is forced, and time passes there
  /// for ever. Otherwise a run ends only where no step is possible, as for Tina.
  bool rests = false;
  friend auto operator<=>(const Question&, const Question&) = default;
};

/// The truth value of the property as written: `absent X` is false if X is reachable.
enum class Truth : std::uint8_t { True, False, Unknown };

/// A variable that a step changed, with its name and values for the user.
struct Change {
  std::string variable;
  std::string before;
  std::string after;
};

/// A date in units of the model.
struct Date {
  std::int64_t value = 0;
  bool strict = false; ///< excluded: dates arbitrarily close to it are meant
  friend bool operator==(const Date&, const Date&) = default;
};

/// A fact that decided something: a variable's value, and since when it had this value.
struct Support {
  std::string variable; ///< empty: a variable that the user does not know
  std::string value;
  std::size_t since = 0; ///< number of steps before it got the value; 0: initial
  friend bool operator==(const Support&, const Support&) = default;
};

/// The value of an origin's ground in a step.
struct GroundValue {
  fiacre::OriginId origin = 0;
  std::uint32_t ground = 0; ///< index in the origin's list of grounds
  std::int64_t value = 0;
  std::vector<Support> support; ///< together these imply the value
};

/// The interval that a step had to wait for.
struct Timer {
  std::size_t since = 0; ///< number of steps before the clock started; 0: at the start
  fiacre::Interval interval;
};

/// A step of a witness.
struct Step {
  std::vector<fiacre::OriginId> origins; ///< of the passed statements, the most descriptive last
  std::vector<std::string> transitions;  ///< the Fiacre transitions: `skill_takeoff_1_t3`
  std::vector<std::string> instances;    ///< the process instances that move: `skill_takeoff_1`
  Date earliest;                         ///< since the start, over all runs with these steps
  std::optional<Date> latest;            ///< nullopt: unbounded
  std::int64_t date = 0; ///< in the concrete run that was replayed, in units of 1/Trace::scale
  std::vector<Change> changes;
  /// The error that this step causes; the run ends with it. Empty if there is none.
  std::string failure;
  std::vector<GroundValue> grounds{};
  std::vector<std::size_t> causes{}; ///< steps on which it directly depends, from 0, ascending
  std::optional<Timer> timer{};      ///< if the step must wait
  bool relevant = true;              ///< to what the trace shows: see trace/causes.h
};

/// What an instance waits for where no step is possible.
struct Wait {
  fiacre::OriginId origin = 0;        ///< of its next step
  std::vector<std::size_t> grounds{}; ///< of the origin: needs that are not met, and their holders
};

/// What may follow the last step of a run, or the start of its loop.
enum class Rest : std::uint8_t {
  No,      ///< a step must follow sooner or later; or this was not computed
  Allowed, ///< no step has to follow
  Forced,  ///< no step is possible, or only steps that change nothing
};

/// A run from the initial state. It has been replayed step by step with its dates.
struct Trace {
  std::int64_t scale = 1;      ///< `Step::date` is in units of 1/scale of the model's unit
  std::vector<Change> initial; ///< the initial value of each watched variable, in `after`
  std::vector<Step> steps;
  /// The date until which no other step has to happen, so that the run shows what it is a witness
  /// of; in units of 1/scale. 0 if the steps alone show it.
  std::int64_t end = 0;
  std::optional<std::size_t> loop; ///< the steps from this one on repeat for ever
  Rest rest = Rest::No;            ///< if the whole run is the witness
  std::vector<Support> support{};  ///< facts by which the last state shows it, if it is a condition
  /// What instances wait for if no step is possible: see waitsIn()
  std::vector<Wait> waits{};
};

/// The answer to a question for a time, in units of the model.
struct Duration {
  bool happens = false; ///< there is something to measure; otherwise nothing else is set
  bool bounded = true;  ///< the longest time is finite
  Date value;           ///< the least upper bound, or the greatest lower bound, of all times
  friend bool operator==(const Duration&, const Duration&) = default;
};

struct Answer {
  Truth truth = Truth::Unknown;
  std::optional<Trace> trace; ///< the witness that a state is reachable or a property is violated
  std::string reason;         ///< if unknown: the limit that was met, or what is not supported
  /// Number of steps of the witness, also if its trace is not needed.
  std::optional<std::size_t> steps{};
  /// For questions for a time, which are True if they are decided. The trace then shows this time;
  /// if the time itself is excluded, one that is closer to it than a unit.
  std::optional<Duration> duration{};
};

/// Methods against state-space explosion. Each has its own file; docs/verification.md argues that
/// they are sound.
enum class Reduction : std::uint8_t {
  DeadVariables, ///< removes variables that nothing reads, and processes that only observe
  LiveVariables, ///< sets a variable that will be written before it is read to 0
  FreeInputs,    ///< lets one value stand for all that the environment may set at any time
  PrivateMoves,  ///< fires at once the steps of a process on inputs that only it reads
  StubbornSets,  ///< fires one urgent transition alone where that is safe
  Slices,        ///< asks a question of the part of the model that has an influence on it
  Refinement,    ///< asks a question of a part that grows, in which the rest may do anything
  Inclusion,     ///< does not expand a zone that another zone of the same discrete state includes
  Extrapolation, ///< drops clock bounds beyond the largest constants (LU)
};

/// Limits hold in all phases. Questions decided before a limit is met stay decided.
struct Limits {
  std::optional<double> seconds;
  std::optional<std::uint64_t> bytes; ///< resident memory of the whole process
  std::optional<std::uint64_t> classes;
};

struct Progress {
  std::uint64_t classes = 0;
  std::uint64_t markings = 0;
  std::uint64_t waiting = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;
  std::uint64_t decided = 0; ///< questions with a witness
  std::uint64_t questions = 0;
};

struct Options {
  std::set<Reduction> reductions{
      Reduction::DeadVariables, Reduction::LiveVariables, Reduction::FreeInputs,
      Reduction::PrivateMoves,  Reduction::StubbornSets,  Reduction::Slices,
      Reduction::Refinement,    Reduction::Inclusion,     Reduction::Extrapolation};
  /// A system with so few classes is explored as a whole: slices are for what is larger, and so are
  /// searches that are led to one goal. Large slices and long led searches have to wait for 30
  /// times as many, slices that are refined for 5 times: see verify/stages.cpp.
  std::uint32_t classesBeforeSlices = 1'000;
  std::uint32_t classesOfLedSearches = 30'000; ///< in total; 0: no such searches
  Limits limits;
  /// Threads for a long breadth-first search of states. Verdicts, counts and traces do not depend
  /// on their number. With several, `clock` may be called by all of them.
  unsigned jobs = 1;
  std::uint32_t classesBeforeThreads = 50'000; ///< a smaller search is over before they pay
  std::uint32_t nodesBeforeThreads = 64;       ///< for each thread: fewer are expanded by one
  std::set<std::string> obliged;               ///< names of processes; see Question::fair
  const std::atomic<bool>* cancelled = nullptr;
  std::function<void(const Progress&)> progress; ///< called a few times a second
  /// Receives the index of each question and its answer, as soon as it is decided. The result then
  /// has no traces, so that at most one trace is in memory.
  std::function<void(std::size_t, Answer)> decided;
  /// Whether the trace of a question's answer is needed; empty: all are. The witness is replayed in
  /// any case.
  std::function<bool(std::size_t)> wantsTrace;
  /// Whether a run is found that shows a time that was asked for. Without it, answers with times
  /// have no witness, and take half the time.
  bool showsTimes = true;
  std::function<double()> clock;  ///< seconds since some moment; empty: the system's clock
  AnswerStore* answers = nullptr; ///< stored answers of this model; decided answers are added
  /// Where the state of the verification is saved from time to time, and when a limit ends it. If
  /// it has an earlier state, the verification goes on from there.
  CheckpointStore* checkpoint = nullptr;
  /// The processes that share long searches for states. All of them call the same functions with
  /// the same arguments; limits hold for each. The results are those of rank 0.
  Ranks* ranks = nullptr;
  /// Where breadth-first searches for states, and the count of state classes, keep what does not
  /// fit into the memory limit. They then begin again, with their graph there.
  SpillStore* spill = nullptr;
  /// If set, these searches begin there at once, with tables of so many bytes.
  std::optional<std::uint64_t> spillBytes;
};

/// Size and cost of an exploration.
struct Exploration {
  std::uint64_t classes = 0;
  std::uint64_t markings = 0; ///< discrete states
  std::uint64_t domains = 0;  ///< distinct zones
  std::uint64_t transitions = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;
  bool complete = false;
  std::string stopped;      ///< the limit that was met, if the exploration is not complete
  std::uint64_t known = 0;  ///< questions that Options::answers had an answer to
  std::uint64_t sliced = 0; ///< number of questions answered by slices
  unsigned ranks = 0;       ///< Options::ranks, if they shared a search; what they sent:
  std::uint64_t messages = 0;
  std::uint64_t sentBytes = 0;
  std::uint64_t spilledBytes = 0; ///< on disk at most; 0: everything was in memory
};

struct Result {
  std::vector<Answer> answers; ///< by question
  Exploration exploration;
};

/// Why a model cannot be explored: the engine does not support a part of Fiacre.
struct Unsupported {
  std::string message;
  fiacre::OriginId origin = 0;
};

/// Answers all questions by one exploration of the dense-time state space. The result is exact: an
/// answer other than Unknown is never wrong. An answer is Unknown only if a limit was reached or
/// the kind of property is not supported.
[[nodiscard]] std::expected<Result, Unsupported> verify(const fiacre::Program& program,
                                                        const fiacre::Provenance& provenance,
                                                        const std::vector<Question>& questions,
                                                        const Options& options = {});

/// Counts the state class graph without reductions, as sift does. Berthomieu and Diaz, "Modeling
/// and verification of time dependent systems using time Petri nets", TSE 1991.
[[nodiscard]] std::expected<Exploration, Unsupported> countClasses(const fiacre::Program& program,
                                                                   const Options& options = {});

} // namespace proskill::verify
