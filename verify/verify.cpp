#include "verify/verify.h"

#include "verify/answer_store.h"
#include "verify/compile/compile.h"
#include "verify/explore/monitor_search.h"
#include "verify/explore/search.h"
#include "verify/reduce/monitor_view.h"
#include "verify/reduce/prepared.h"
#include "verify/slice/slice_search.h"
#include "verify/state/state_layout.h"
#include "verify/trace/witness.h"

#include <algorithm>
#include <map>
#include <utility>

namespace proskill::verify {

namespace {

/// Limit of questions times transitions; beyond it, determining the slices takes seconds.
constexpr std::size_t kMostWork = 1'000'000;
/// The same limit for led searches, each of which prepares the whole system.
constexpr std::size_t kMostLedWork = 100'000;
constexpr NodeIndex kFewestLedClasses = 100; ///< a search of fewer is not worth its preparation

Answer unknown(std::string reason) { return {Truth::Unknown, std::nullopt, std::move(reason)}; }

/// Whether a stored mark belongs to the monitor and to a run with this number of steps.
bool fits(const MonitorMove& mark, const Monitor& monitor, std::size_t steps) {
  if (mark.location >= monitor.locations.size()) return false;
  const auto& edges = monitor.locations[mark.location].edges;
  return (mark.ticks || mark.edge < edges.size()) && (!mark.atStep || mark.after > 0) &&
         mark.after <= mark.until && mark.until <= steps;
}

/// Whether stored evidence can be replayed. It may come from anywhere, so nothing is assumed of it.
bool fits(const Evidence& evidence, const Goal& goal, const System& system) {
  const auto& marks = evidence.marks;
  const auto& monitor = goal.monitor;
  const bool begins = marks.empty() || std::ranges::find(monitor.initial, marks[0].location) !=
                                           monitor.initial.end();
  return begins && (goal.kind == GoalKind::Run || marks.empty()) &&
         std::ranges::all_of(
             marks, [&](const auto& it) { return fits(it, monitor, evidence.steps.size()); }) &&
         std::ranges::all_of(evidence.steps,
                             [&](auto id) { return id < system.transitions.size(); }) &&
         std::ranges::all_of(evidence.clocks,
                             [&](const auto& it) { return it.clock < system.clocks.size(); }) &&
         evidence.loop.value_or(0) <= evidence.steps.size() &&
         evidence.rest.value_or(0) <= marks.size();
}

/// The answer if the search has found no witness.
Answer answerWithoutEvidence(const Goal& goal, const Exploration& exploration,
                             const std::string& progressStopped) {
  if (goal.kind == GoalKind::Unsupported) return unknown(goal.reason);
  if (!exploration.complete) return unknown(exploration.stopped);
  if (goal.kind == GoalKind::Stuck && !progressStopped.empty()) return unknown(progressStopped);
  return {Truth::True, std::nullopt, {}};
}

/// Whether a reduction preserves everything that a monitor observes.
bool suits(const Monitor& monitor, Reduction reduction, const System& system) {
  switch (reduction) {
  case Reduction::DeadVariables: return monitor.ofPoints || watchesStates(monitor, system);
  case Reduction::FreeInputs: return watchesPoints(monitor) || watchesStates(monitor, system);
  case Reduction::StubbornSets: return watchesPoints(monitor);
  case Reduction::PrivateMoves:
  case Reduction::Slices: return false;
  case Reduction::LiveVariables:
  case Reduction::Inclusion:
  case Reduction::Extrapolation: return true;
  }
  std::unreachable();
}

/// Answers questions to a compiled model, each as soon as it is decided.
class Verification {
public:
  Verification(const Compiled& model, const fiacre::Provenance& origins,
               const std::vector<Question>& of, const Options& with, LimitWatch& watch, Result& to)
      : compiled(model),
        provenance(origins),
        questions(of),
        options(with),
        limits(watch),
        result(to),
        whole(withStateLayout(model.system)) {
    result.exploration.complete = true;
  }

  /// \throw LimitMet where it is met before there is anything to explore
  std::optional<Unsupported> run() {
    findKnown();
    std::vector<std::size_t> ofStates;
    std::vector<std::size_t> ofRuns;
    for (std::size_t i = 0; i < compiled.goals.size(); ++i)
      if (!known.contains(i))
        (compiled.goals[i].kind == GoalKind::Run ? ofRuns : ofStates).push_back(i);
    if (!ofStates.empty() || compiled.goals.empty())
      if (auto failure = explore(ofStates)) return failure;
    for (auto i : ofRuns)
      if (auto failure = watch(i)) return failure;
    return std::nullopt;
  }

private:
  /// Most reductions are sound only without priorities: a step that is dropped or delayed might
  /// have priority over others.
  [[nodiscard]] bool takes(Reduction reduction) const {
    const std::set<Reduction> withPriorities{Reduction::Inclusion, Reduction::Extrapolation};
    return options.reductions.contains(reduction) &&
           (!compiled.system.hasPriorities || withPriorities.contains(reduction));
  }

  [[nodiscard]] std::function<bool(Reduction)> may() const {
    return [this](Reduction reduction) { return takes(reduction); };
  }

  /// Answers what was decided before. Replays take time, so answers that need none come first.
  void findKnown() {
    if (!options.answers) return;
    std::map<std::size_t, Evidence> violations;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      auto found = options.answers->find(questions[i]);
      if (found && found->holds)
        answerKnown(i, {Truth::True, std::nullopt, {}});
      else if (found && fits(found->evidence, compiled.goals[i], whole))
        violations.emplace(i, std::move(found->evidence));
    }
    const Reductions none;
    const Witness witness(whole, none, provenance, limits);
    for (auto& [i, evidence] : violations) {
      const auto& goal = compiled.goals[i];
      evidence.monitor = goal.kind == GoalKind::Run ? &goal.monitor : nullptr;
      auto made = shown(i, evidence, witness);
      if (made) answerKnown(i, std::move(*made));
    }
  }

  void answerKnown(std::size_t index, Answer made) {
    answer(index, std::move(made));
    known.insert(index);
    result.exploration.known = known.size();
  }

  /// Replays evidence on the whole system.
  /// \return the answer that it shows, or why it shows none \throw LimitMet
  [[nodiscard]] std::expected<Answer, std::string>
  shown(std::size_t index, const Evidence& evidence, const Witness& witness) const {
    const auto& goal = compiled.goals[index];
    if (options.wantsTrace && !options.wantsTrace(index)) {
      auto wrong = witness.refutation(goal, evidence);
      if (!wrong.empty()) return std::unexpected(std::move(wrong));
      return Answer{Truth::False, std::nullopt, {}, evidence.steps.size()};
    }
    auto trace = witness.trace(goal, evidence);
    if (!trace) return std::unexpected(std::move(trace.error()));
    const auto steps = trace->steps.size();
    return Answer{Truth::False, std::move(*trace), {}, steps};
  }

  /// Answers questions about states and steps. A long exploration is interrupted: slices answer
  /// what they can, and the exploration starts again with the remaining questions, which is less
  /// work.
  std::optional<Unsupported> explore(std::vector<std::size_t> which) {
    if (which.empty() || !usesSlices()) return exploreWhole(which, {});
    std::erase_if(which, [&](std::size_t i) { return isAnsweredPlainly(i); });
    if (which.empty()) return std::nullopt;
    bool isPaused = false;
    const Pause pause{options.classesBeforeSlices, [&] {
                        isPaused = exploreSlices(which);
                        isPaused = exploreLed(which) || isPaused;
                        return !isPaused;
                      }};
    auto failure = exploreWhole(which, pause);
    if (failure || !isPaused) return failure;
    std::erase_if(which, [&](std::size_t i) { return answered.contains(i); });
    if (!which.empty()) return exploreWhole(which, {});
    result.exploration.complete = false;
    result.exploration.stopped = "all questions decided";
    return std::nullopt;
  }

  /// \param isLed whether to search for the only goal, states closest to it first
  std::optional<Unsupported> exploreWhole(const std::vector<std::size_t>& which, const Pause& pause,
                                          bool isLed = false) {
    std::vector<Goal> goals;
    for (auto i : which) goals.push_back(compiled.goals[i]);
    const Prepared prepared(compiled.system, goals, may(), limits);
    const Witness witness(whole, prepared.reductions, provenance, limits);
    std::optional<GoalDistance> distance;
    if (isLed)
      distance.emplace(compiled.system, prepared.system, goals[0], prepared.reductions.dropped,
                       limits);
    auto found = search(
        prepared.system, goals, prepared.reductions, prepared.extrapolation, limits,
        [&](std::size_t i, const Evidence& evidence) { answerBy(which[i], evidence, witness); },
        pause, distance ? &*distance : nullptr);
    if (found.failure) return found.failure;
    if (isLed || found.paused)
      addCounts(result.exploration, found.statistics);
    else
      add(result.exploration, found.statistics);
    if (found.paused) return std::nullopt;
    for (std::size_t i = 0; i < goals.size(); ++i)
      if (!found.goals[i]) answerWithout(which[i], found.statistics, found.progressStopped);
    return std::nullopt;
  }

  /// Slices omit errors, so they are used only if errors are asked for or cannot happen.
  [[nodiscard]] bool usesSlices() {
    return takes(Reduction::Slices) && !compiled.system.hasPriorities &&
           (errorsAreAsked() || isPlainlyNever(whole, Goal{.kind = GoalKind::Error}, limits));
  }

  bool isAnsweredPlainly(std::size_t index) {
    if (!isPlainlyNever(whole, compiled.goals[index], limits)) return false;
    keep(index, {true, {}});
    answer(index, {Truth::True, std::nullopt, {}});
    return true;
  }

  /// \return whether any of the questions was answered
  bool exploreSlices(std::vector<std::size_t> which) {
    std::erase_if(which, [&](std::size_t i) { return answered.contains(i); });
    if (which.size() * whole.transitions.size() > kMostWork) return false;
    const Reductions none;
    const Witness witness(whole, none, provenance, limits);
    SliceSearch slices(compiled.system, whole, provenance, may(), limits);
    const Bits decided = slices.decide(compiled.goals, which, result.exploration,
                                       [&](std::size_t i, const Evidence* evidence) {
                                         return isShownBySlice(i, evidence, witness);
                                       });
    result.exploration.sliced += decided.count();
    return !decided.empty();
  }

  /// Looks for goals that lie deep, by a short search for each question, states closest to the goal
  /// first. \return whether any of the questions was answered
  bool exploreLed(const std::vector<std::size_t>& which) {
    const auto before = answered.size();
    std::vector<std::size_t> left;
    for (auto i : which)
      if (!answered.contains(i) && GoalDistance::isFor(compiled.goals[i])) left.push_back(i);
    if (left.empty() || left.size() * whole.transitions.size() > kMostLedWork) return false;
    const auto share = options.classesOfLedSearches / static_cast<NodeIndex>(left.size());
    if (share < kFewestLedClasses) return false;
    for (auto i : left) exploreWhole({i}, {share, [] { return false; }}, true);
    return answered.size() > before;
  }

  bool isShownBySlice(std::size_t index, const Evidence* evidence, const Witness& witness) {
    if (!evidence) {
      keep(index, {true, {}});
      answer(index, {Truth::True, std::nullopt, {}});
      return true;
    }
    auto made = shown(index, *evidence, witness);
    if (!made) return false;
    keep(index, {false, *evidence});
    answer(index, std::move(*made));
    return true;
  }

  /// Answers a question about runs, by an exploration of its own.
  std::optional<Unsupported> watch(std::size_t index) {
    const Goal& goal = compiled.goals[index];
    const auto seen = goalsOf(goal.monitor);
    const Prepared prepared(
        compiled.system, seen,
        [&](Reduction r) { return takes(r) && suits(goal.monitor, r, compiled.system); }, limits);
    auto found = watchFor(prepared.system, goal.monitor, prepared.reductions, options.obliged,
                          errorsAreAsked(), limits);
    if (!found.failure.empty()) return Unsupported{found.failure, found.failureOrigin};
    if (found.evidence) found.statistics.complete = true;
    add(result.exploration, found.statistics);
    const Witness witness(whole, prepared.reductions, provenance, limits);
    if (found.evidence)
      answerBy(index, *found.evidence, witness);
    else
      answerWithout(index, found.statistics, {});
    return std::nullopt;
  }

  /// Answers by evidence, with its trace. If a limit is met before, the verdict has no trace.
  void answerBy(std::size_t index, const Evidence& evidence, const Witness& witness) {
    const auto& goal = compiled.goals[index];
    try {
      const Evidence tidied = witness.tidied(goal, evidence);
      auto made = shown(index, tidied, witness);
      if (!made) return answer(index, unknown("internal error, please report it: " + made.error()));
      keep(index, {false, tidied});
      answer(index, std::move(*made));
    } catch (const LimitMet& limit) {
      answer(index, {Truth::False, std::nullopt, "without a trace: " + limit.which});
    }
  }

  void answerWithout(std::size_t index, const Exploration& exploration,
                     const std::string& progressStopped) {
    auto made = answerWithoutEvidence(compiled.goals[index], exploration, progressStopped);
    if (made.truth == Truth::True) keep(index, {true, {}});
    answer(index, std::move(made));
  }

  void keep(std::size_t index, const KnownAnswer& made) {
    if (options.answers) options.answers->keep(questions[index], made);
  }

  [[nodiscard]] bool errorsAreAsked() const {
    return std::ranges::any_of(compiled.goals,
                               [](const Goal& goal) { return goal.kind == GoalKind::Error; });
  }

  void answer(std::size_t index, Answer made) {
    result.answers[index] = {made.truth, std::nullopt, made.reason, made.steps};
    if (made.truth != Truth::Unknown) answered.insert(index);
    if (options.decided && made.truth != Truth::Unknown)
      options.decided(index, std::move(made));
    else
      result.answers[index].trace = std::move(made.trace);
  }

  const Compiled& compiled;
  const fiacre::Provenance& provenance;
  const std::vector<Question>& questions;
  const Options& options;
  LimitWatch& limits;
  Result& result;
  System whole; ///< with every cell kept
  std::set<std::size_t> answered;
  std::set<std::size_t> known; ///< goals that Options::answers had the answers to
};

/// Makes the undecided questions inconclusive when a limit is met.
void giveUp(const LimitMet& limit, Result& result) {
  result.exploration.complete = false;
  result.exploration.stopped = limit.which;
  for (auto& answer : result.answers)
    if (answer.truth == Truth::Unknown && answer.reason.empty()) answer = unknown(limit.which);
}

} // namespace

std::expected<Result, Unsupported> verify(const fiacre::Program& program,
                                          const fiacre::Provenance& provenance,
                                          const std::vector<Question>& questions,
                                          const Options& options) {
  LimitWatch limits(options);
  Result result;
  result.answers.resize(questions.size());
  try {
    const auto compiled = compile(program, provenance, questions, &limits);
    if (!compiled) return std::unexpected(compiled.error());
    Verification verification(*compiled, provenance, questions, options, limits, result);
    if (auto failure = verification.run()) return std::unexpected(*failure);
  } catch (const LimitMet& limit) {
    giveUp(limit, result);
  }
  result.exploration.seconds = limits.seconds();
  return result;
}

} // namespace proskill::verify
