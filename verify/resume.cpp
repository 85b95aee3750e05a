#include "verify/verification.h"

#include "verify/explore/conclude.h"
#include "verify/trace/step_names.h"
#include "verify/trace/stored_evidence.h"

#include <algorithm>

/// How a verification is saved and resumed. Between two searches everything is settled. During a
/// search of states, what it has decided belongs to the search: a process that goes on with it
/// makes these traces again.
namespace proskill::verify {

std::optional<Unsupported> Verification::resume() {
  auto& from = *checkpoint->earlier();
  Settled read = readSettled(from, questions.size());
  const bool isSearching = from.flag();
  if (!from.hasFailed() && !answerSettled(std::move(read.decided))) from.fail();
  for (const auto question : read.asked)
    if (hasOwnSearch(compiled.goals[question])) from.fail();
  if ((isSearching && read.statesAreDone) || read.stage > stagesOf(options).size()) from.fail();
  if (from.hasFailed()) return Unsupported{checkpoint->endEarlier(0), 0};
  settled.asked = std::move(read.asked);
  settled.statesAreDone = read.statesAreDone;
  result.exploration = read.exploration;
  stage = read.stage;
  slicesAreDone = read.slicesAreDone;
  if (options.answers) options.answers->begin(stepNames(whole));
  if (isSearching) return std::nullopt;
  if (auto problem = checkpoint->endEarlier(read.exploration.classes); !problem.empty())
    return Unsupported{problem, 0};
  settle();
  return std::nullopt;
}

/// \return whether all are confirmed
bool Verification::answerSettled(std::vector<Settled::Decided> decided) {
  std::map<std::size_t, Evidence> violations;
  for (auto& it : decided) {
    if (known.contains(it.question)) return false;
    if (!it.reason.empty()) {
      answer(it.question, unknown(it.reason));
      known.insert(it.question);
    } else if (it.answer.duration) {
      answerKnownTime(it.question, it.answer);
    } else if (it.answer.holds) {
      answerKnown(it.question, {Truth::True, std::nullopt, {}}, it.answer);
    } else if (canBeReplayed(it.answer.evidence, compiled.goals[it.question], whole)) {
      violations.emplace(it.question, std::move(it.answer.evidence));
    }
  }
  replayKnown(violations);
  return known.size() == decided.size();
}

/// Notes that everything so far is settled, unless a limit left something open.
void Verification::settle() {
  if (!checkpoint || !isSaving) return;
  if (!limits.lastMet().empty()) {
    isSaving = false;
    return;
  }
  settledCount = settled.decided.size();
  settled.exploration = result.exploration;
  settled.stage = stage;
  settled.slicesAreDone = slicesAreDone;
}

void Verification::settleStates(bool isLimited) {
  isSaving = isSaving && !isLimited;
  if (!checkpoint || !isSaving) return;
  settled.statesAreDone = true;
  settled.asked.clear();
  settle();
  saveSometimes();
}

/// Without a graph this takes milliseconds, and there may be thousands of short searches.
void Verification::saveSometimes() {
  constexpr double kBetweenSaves = 1;
  if (limits.seconds() - savedAt < kBetweenSaves) return;
  checkpoint->save({});
  savedAt = limits.seconds();
}

std::optional<Unsupported> Verification::searchAndSettle(std::size_t index) {
  limits.forgetMet();
  try {
    if (auto failure = searchFor(index)) return failure;
  } catch (const LimitMet&) {
    settleRun();
    throw;
  }
  settleRun();
  return std::nullopt;
}

/// If a limit has ended the search, it is to be done again as a whole, and later ones as well.
void Verification::settleRun() {
  if (!checkpoint || !isSaving) return;
  if (limits.lastMet().empty()) {
    settle();
    saveSometimes();
  } else {
    checkpoint->save({});
    isSaving = false;
  }
}

/// What happens when a search of states has reached the size of a stage.
/// \return whether the search is to start again with what is left
bool Verification::isStoppedAt(const Stage& reached, const std::vector<std::size_t>& which) {
  ++stage;
  const auto before = settled.decided.size();
  const bool isStopped = answersAny(reached, which);
  if (!checkpoint || !isSaving) return isStopped;
  // the stage is settled as a whole or not at all, so the next process begins it again
  if (!limits.lastMet().empty()) throw LimitMet{limits.lastMet()};
  if (isStopped) return true;
  settled.exploration = result.exploration;
  settled.stage = stage;
  settled.slicesAreDone = slicesAreDone;
  settleSince(before);
  return false;
}

/// Settles what a stage has decided about runs, from this index on. What the search under way has
/// decided before belongs to that search.
void Verification::settleSince(std::size_t index) {
  const auto begin = settled.decided.begin();
  const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
  std::rotate(at(settledCount), at(index), settled.decided.end());
  settledCount += settled.decided.size() - index;
}

} // namespace proskill::verify
