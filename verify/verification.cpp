#include "verify/verification.h"

#include "verify/assistants.h"
#include "verify/ctl/lost_search.h"
#include "verify/explore/conclude.h"
#include "verify/explore/monitor_search.h"
#include "verify/measure/duration_search.h"
#include "verify/ranks/shared_search.h"
#include "verify/reduce/monitor_view.h"
#include "verify/reduce/prepared.h"
#include "verify/slice/slice_search.h"
#include "verify/spill/spilled_search.h"
#include "verify/state/state_layout.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

Verification::Verification(const Compiled& model, const fiacre::Provenance& origins,
                           const std::vector<Question>& of, const Options& with, LimitWatch& watch,
                           Result& to)
    : compiled(model),
      provenance(origins),
      questions(of),
      options(with),
      limits(watch),
      result(to),
      whole(withStateLayout(model.system)) {
  result.exploration.complete = true;
  if (!options.checkpoint) return;
  checkpoint.emplace(*options.checkpoint, limits);
  checkpoint->setHead(
      [this](CheckpointWriter& write) { verify::write(write, settled, settledCount); });
  isSaving = true;
}

std::optional<Unsupported> Verification::run() {
  if (checkpoint && checkpoint->earlier()) {
    if (auto failure = resume()) return failure;
  } else {
    findKnown();
  }
  std::vector<std::size_t> ofStates;
  std::vector<std::size_t> ofRuns;
  for (std::size_t i = 0; i < compiled.goals.size(); ++i)
    if (!known.contains(i)) (hasOwnSearch(compiled.goals[i]) ? ofRuns : ofStates).push_back(i);
  if (!settled.statesAreDone && (!ofStates.empty() || compiled.goals.empty()))
    if (auto failure = exploreStates(std::move(ofStates))) return failure;
  for (auto i : ofRuns)
    if (!answered.contains(i))
      if (auto failure = searchAndSettle(i)) return failure;
  if (isSaving) checkpoint->finish();
  return std::nullopt;
}

bool Verification::takes(Reduction reduction) const {
  return mayTake(reduction, options, compiled.system);
}

std::function<bool(Reduction)> Verification::may() const {
  return [this](Reduction reduction) { return takes(reduction); };
}

std::optional<Unsupported> Verification::exploreStates(std::vector<std::size_t> which) {
  limits.forgetMet();
  const bool isResumed = checkpoint && checkpoint->earlier();
  return explore(isResumed ? settled.asked : std::move(which));
}

/// Answers questions about states and steps. A search that turns out to be long is interrupted:
/// slices and led searches answer what they can, and the search starts again with the remaining
/// questions, which is less work.
std::optional<Unsupported> Verification::explore(std::vector<std::size_t> which) {
  if (which.empty() || !usesParts()) return exploreWhole(which, {});
  bool isResumed = checkpoint && checkpoint->earlier();
  if (!isResumed) {
    std::erase_if(which, [&](std::size_t i) { return isAnsweredPlainly(i); });
    if (which.empty()) return settleStates(false), std::nullopt;
    if (isEdit) exploreSlices(which, {}); // what an edit does not concern is known
    stage = isEdit ? 1 : 0;
    if (!limits.lastMet().empty()) isSaving = false;
  }
  const auto stages = stagesOf(options);
  for (bool isStopped = true; isStopped; isResumed = false) {
    isStopped = false;
    if (!isResumed) std::erase_if(which, [&](std::size_t i) { return answered.contains(i); });
    if (which.empty()) return stopDecided();
    if (stage == stages.size()) refinement.reset();
    const auto size = [&] { return stage < stages.size() ? stages[stage].at : SearchSize{}; };
    const Pause pause{size(), [&]() -> std::optional<SearchSize> {
                        isStopped = isStoppedAt(stages[stage], which) ||
                                    (options.ranks && stage == stages.size());
                        return isStopped ? std::nullopt : std::optional(size());
                      }};
    if (auto failure = exploreWhole(which, pause)) return failure;
  }
  return std::nullopt;
}

bool Verification::answersAny(const Stage& stage, const std::vector<std::size_t>& which) {
  const bool bySlices =
      !slicesAreDone && stage.slices.classes > 0 && exploreSlices(which, stage.slices);
  // these two often decide most of what is possible, so they come before slices that grow
  const bool isNew = exploreNewest(which, stage.newest);
  const bool isSampled = sampleRuns(which, stage.sampled, false);
  const bool isRefined = refine(which, stage.refined);
  exploreRuns(stage);
  const bool isLed = exploreLed(which, stage.led, stage.ledEach);
  const bool byWalks = exploreByWalks(which, stage.walks);
  if (byWalks) exploreLed(which, stage.led, stage.ledEach); // fewer are left, so each gets more
  // random runs have long traces, so the others come first
  const bool isTraced = stage.samplesTraces && sampleRuns(which, stage.sampled, true);
  return bySlices || isRefined || isSampled || isNew || isLed || byWalks || isTraced;
}

std::optional<Unsupported> Verification::stopDecided() {
  result.exploration.complete = false;
  result.exploration.stopped = "all questions decided";
  settleStates(false);
  return std::nullopt;
}

/// \param order Led: to the only goal, states closest to it first
std::optional<Unsupported> Verification::exploreWhole(const std::vector<std::size_t>& which,
                                                      const Pause& pause, Order order) {
  std::vector<Goal> goals;
  for (auto i : which) goals.push_back(compiled.goals[i]);
  const Prepared prepared(compiled.system, goals, may(), limits);
  limits.checkLargeGrowth(3 * Enabling::mostBytes(whole)); // two of the witness, one of the search
  const Witness witness(whole, prepared.reductions, provenance, limits);
  std::optional<GoalDistance> distance;
  if (order == Order::Led)
    distance.emplace(compiled.system, prepared.system, goals[0], prepared.reductions.dropped,
                     limits);
  std::optional<Novelty> novelty;
  if (order == Order::Led || order == Order::Newest) novelty.emplace(prepared.system);
  const bool isInOrder = order == Order::BreadthFirst;
  if (isInOrder) settle();
  if (isInOrder) settled.asked = which;
  const OnEvidence onFound = [&](std::size_t i, const Evidence& evidence) {
    answerBy(which[i], evidence, witness);
  };
  const bool isShared = options.ranks && isInOrder && pause.at.classes == UINT64_MAX;
  if (isShared) callAssistants(*options.ranks, which);
  const auto inMemory = [&] {
    return search(prepared.system, goals, prepared.reductions, prepared.extrapolation, limits,
                  onFound, pause,
                  {.distance = distance ? &*distance : nullptr,
                   .walks = order == Order::Walks,
                   .novelty = novelty ? &*novelty : nullptr},
                  isInOrder && isSaving ? &*checkpoint : nullptr);
  };
  auto found = isShared ? searchByRanks(prepared, goals, limits, *options.ranks, onFound)
               : isInOrder && options.spill
                   ? searchWithSpill(prepared, goals, limits, options, inMemory, onFound)
                   : inMemory();
  if (found.failure) return found.failure;
  if (!isInOrder || found.paused)
    addCounts(result.exploration, found.statistics);
  else
    add(result.exploration, found.statistics);
  if (found.paused) return std::nullopt;
  for (std::size_t i = 0; i < goals.size(); ++i)
    if (!found.goals[i]) answerWithout(which[i], found.statistics, found.progressStopped);
  if (isInOrder) settleStates(found.limited);
  return std::nullopt;
}

/// Slices omit errors, so they are used only if errors are asked for or cannot happen.
bool Verification::usesParts() {
  return (takes(Reduction::Slices) || takes(Reduction::Refinement)) &&
         !compiled.system.hasPriorities && (askForErrors(compiled.goals) || areErrorsExcluded());
}

bool Verification::isAnsweredPlainly(std::size_t index) {
  return isPlainlyNever(whole, compiled.goals[index], limits) && answerTrue(index);
}

bool Verification::answerTrue(std::size_t index) {
  keep(index, {true, {}});
  answer(index, {Truth::True, std::nullopt, {}});
  return true;
}

/// \return whether any of the questions was answered
/// \param most size of the searches together
bool Verification::exploreSlices(std::vector<std::size_t> which, const SearchSize& most) {
  std::erase_if(which, [&](std::size_t i) { return answered.contains(i); });
  if (!takes(Reduction::Slices) || which.size() * whole.transitions.size() > kMostWork)
    return false;
  SliceSearch slices(compiled.system, whole, provenance, may(), limits, options.answers);
  const bool some = isAnyDecided([&](const auto& onDecided) {
    return slices.decide(compiled.goals, which, most, result.exploration, onDecided);
  });
  slicesAreDone = !slices.wasCutShort();
  return some;
}

/// \return whether any of the questions was answered
bool Verification::refine(std::vector<std::size_t> which, const Refinement::Budget& budget) {
  if (budget.together == 0 || !takes(Reduction::Refinement)) return false;
  std::erase_if(which, [&](std::size_t i) { return answered.contains(i); });
  if (which.empty()) return false;
  auto& slices = refinementOfAll();
  return isAnyDecided([&](const auto& onDecided) {
    Bits decided = slices.decide(compiled.goals, which, budget, result.exploration, onDecided);
    for (auto i : which)
      if (compiled.goals[i].kind == GoalKind::Stuck && areErrorsExcluded() &&
          slices.showProgress(budget, result.exploration) && onDecided(i, nullptr))
        decided.insert(static_cast<std::uint32_t>(i));
    return decided;
  });
}

Refinement& Verification::refinementOfAll() {
  if (!refinement)
    refinement.emplace(compiled.system, whole, provenance, may(), limits, options.answers);
  return *refinement;
}

/// Whether it is known that no step fails.
bool Verification::areErrorsExcluded() {
  for (std::size_t i = 0; i < compiled.goals.size(); ++i)
    if (compiled.goals[i].kind == GoalKind::Error && result.answers[i].truth == Truth::True)
      return true;
  return isPlainlyNever(whole, Goal{.kind = GoalKind::Error}, limits);
}

/// \param decide asks parts of the system; it receives a function for the answers
bool Verification::isAnyDecided(const auto& decide) {
  const Witness witness(whole, none, provenance, limits);
  const Bits decided = decide([&](std::size_t i, const Evidence* evidence) {
    return isShownBySlice(i, evidence, witness);
  });
  result.exploration.sliced += decided.count();
  return !decided.empty();
}

bool Verification::isShownBySlice(std::size_t index, const Evidence* evidence,
                                  const Witness& witness) {
  if (!evidence) return answerTrue(index);
  auto made = shownIfPossible(index, *evidence, witness);
  if (!made) return false;
  keep(index, {false, *evidence});
  answer(index, std::move(*made));
  return true;
}

/// If the trace of a run meets the memory limit, the run is confirmed without it.
std::optional<Answer> Verification::shownIfPossible(std::size_t index, const Evidence& evidence,
                                                    const Witness& witness) const {
  const auto& goal = compiled.goals[index];
  try {
    auto made = shown(index, goal, evidence, witness);
    return made ? std::optional(std::move(*made)) : std::nullopt;
  } catch (const LimitMet& limit) {
    if (limit.which != kMemoryLimitMet) throw;
    if (!witness.answer(goal, evidence, false)) return std::nullopt;
    return Answer{Truth::False, std::nullopt, "without a trace: " + limit.which};
  }
}

std::optional<Unsupported> Verification::searchFor(std::size_t index) {
  const Goal& goal = compiled.goals[index];
  if (goal.kind == GoalKind::Lost) return searchForLost(index, goal);
  return goal.kind == GoalKind::Run ? watch(index, goal) : measure(index, goal);
}

std::optional<Unsupported> Verification::searchForLost(std::size_t index, const Goal& goal) {
  const auto takesIt = [&](Reduction r) { return takes(r) && r != Reduction::PrivateMoves; };
  const Prepared prepared(compiled.system, preservedFor(goal), takesIt, limits);
  auto found = searchLost(prepared, goal, askForErrors(compiled.goals), limits);
  return answerWith(found, index, prepared.reductions);
}

std::optional<Unsupported> Verification::answerWith(const auto& found, std::size_t index,
                                                    const Reductions& reductions) {
  if (!found.failure.empty()) return Unsupported{found.failure, found.failureOrigin};
  add(result.exploration, found.statistics);
  if (found.evidence)
    answerBy(index, *found.evidence, Witness(whole, reductions, provenance, limits));
  else
    answerWithout(index, found.statistics, {});
  return std::nullopt;
}

std::optional<Unsupported> Verification::measure(std::size_t index, const Goal& goal) {
  const Suits may = [&](const Monitor& monitor, Reduction r) {
    return takes(r) && suits(monitor, r, compiled.system);
  };
  auto found = searchDuration(compiled.system, goal, may, askForErrors(compiled.goals),
                              options.showsTimes, limits);
  if (found.failure) return found.failure;
  add(result.exploration, found.statistics);
  if (!found.duration) return answer(index, unknown(found.unknown)), std::nullopt;
  const auto* used = found.run ? &found.run->prepared->reductions : &none;
  const Witness witness(whole, *used, provenance, limits);
  const auto shows = found.run ? std::optional(found.run->goal) : std::nullopt;
  Evidence evidence;
  if (shows) evidence = witness.tidied(found.run->goal, found.run->evidence);
  auto made = timeAnswer(index, *found.duration, shows, evidence, witness);
  if (made.truth == Truth::True) keep(index, {true, evidence, found.duration});
  answer(index, std::move(made));
  return std::nullopt;
}

/// Searches the whole for a run. \param most number of classes; if these do not decide it, the
/// question stays open
std::optional<Unsupported> Verification::watchWithin(std::size_t index, std::uint64_t most) {
  const Goal& goal = compiled.goals[index];
  const auto suitable = [&](Reduction r) {
    return takes(r) && suits(goal.monitor, r, compiled.system);
  };
  const Prepared prepared(compiled.system, goalsOf(goal.monitor), suitable, limits);
  auto found = watchFor(prepared.system, goal.monitor, prepared.reductions, options.obliged,
                        askForErrors(compiled.goals), limits, nullptr, most);
  if (found.evidence) found.statistics.complete = true;
  const bool isOpen = found.failure.empty() && !found.statistics.complete;
  if (!isOpen || most == UINT64_MAX) return answerWith(found, index, prepared.reductions);
  addCounts(result.exploration, found.statistics);
  return std::nullopt;
}

/// Answers by evidence, with its trace. If a limit is met before, the verdict has no trace.
void Verification::answerBy(std::size_t index, const Evidence& evidence, const Witness& witness) {
  const auto& goal = compiled.goals[index];
  try {
    limits.checkNow(); // many answers may follow the one that meets a limit
    const Evidence tidied = witness.tidied(goal, evidence);
    auto made = shown(index, goal, tidied, witness);
    if (!made) return answer(index, unknown("internal error, please report it: " + made.error()));
    keep(index, {false, tidied});
    answer(index, std::move(*made));
  } catch (const LimitMet& limit) {
    answer(index, {Truth::False, std::nullopt, "without a trace: " + limit.which});
  }
}

void Verification::answerWithout(std::size_t index, const Exploration& exploration,
                                 const std::string& progressStopped) {
  auto made = answerWithoutEvidence(compiled.goals[index], exploration, progressStopped);
  if (made.truth == Truth::True) keep(index, {true, {}});
  answer(index, std::move(made));
}

void Verification::keep(std::size_t index, const KnownAnswer& made) {
  if (checkpoint) settled.decided.push_back({index, made, {}});
  if (options.answers) options.answers->keep(questions[index], made);
}

void Verification::answer(std::size_t index, Answer made) {
  if (options.spill && made.reason == kMemoryLimitMet && hasOwnSearch(compiled.goals[index]))
    made.reason = "only searches for states go to disk: " + made.reason;
  result.answers[index] = {made.truth, std::nullopt, made.reason, made.steps, made.duration};
  if (made.truth != Truth::Unknown)
    answered.insert(index);
  else if (checkpoint)
    settled.decided.push_back({index, {}, made.reason});
  if (options.decided && made.truth != Truth::Unknown)
    options.decided(index, std::move(made));
  else
    result.answers[index].trace = std::move(made.trace);
}

} // namespace proskill::verify
