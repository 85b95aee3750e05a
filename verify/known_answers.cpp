#include "verify/verification.h"

#include "verify/explore/conclude.h"
#include "verify/measure/duration_search.h"
#include "verify/state/state_layout.h"
#include "verify/trace/step_names.h"
#include "verify/trace/stored_evidence.h"

#include <algorithm>

namespace proskill::verify {

/// Answers what was decided before. Replays take time, so answers that need none come first.
void Verification::findKnown() {
  if (!options.answers) return;
  std::map<std::size_t, Evidence> violations;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    auto found = options.answers->find(questions[i]);
    if (found && found->duration)
      answerKnownTime(i, *found);
    else if (found && found->holds)
      answerKnown(i, {Truth::True, std::nullopt, {}}, *found);
    else if (found && canBeReplayed(found->evidence, compiled.goals[i], whole))
      violations.emplace(i, std::move(found->evidence));
  }
  replayKnown(violations);
  if (known.size() < questions.size()) findEarlier();
}

/// Replays the violations of an earlier version of the model: most edits leave them as they are.
void Verification::findEarlier() {
  options.answers->begin(stepNames(whole));
  std::map<std::size_t, Evidence> violations;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    if (known.contains(i) || !isShownByOneRun(compiled.goals[i])) continue;
    auto found = options.answers->earlier(questions[i]);
    if (found && canBeReplayed(*found, compiled.goals[i], whole))
      violations.emplace(i, std::move(*found));
  }
  for (auto i : replayKnown(violations))
    options.answers->keep(questions[i], {false, violations.at(i)});
  isEdit = !violations.empty();
}

/// \return those that are confirmed
std::set<std::size_t> Verification::replayKnown(std::map<std::size_t, Evidence>& violations) {
  std::set<std::size_t> confirmed;
  const Witness witness(whole, none, provenance, limits);
  std::vector<std::size_t> order; // a common beginning of several is played once
  for (const auto& [i, evidence] : violations) order.push_back(i);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return violations.at(a).steps < violations.at(b).steps;
  });
  for (auto i : order) {
    const auto& goal = compiled.goals[i];
    auto& evidence = violations.at(i);
    evidence.monitor = goal.kind == GoalKind::Run ? &goal.monitor : nullptr;
    auto made = shown(i, goal, evidence, witness);
    if (!made) continue;
    answerKnown(i, std::move(*made), {false, evidence});
    confirmed.insert(i);
  }
  return confirmed;
}

void Verification::answerKnownTime(std::size_t index, const KnownAnswer& found) {
  std::optional<Goal> goal;
  if (options.showsTimes) goal = goalShowing(compiled.goals[index], *found.duration);
  if (goal && !canBeReplayed(found.evidence, *goal, whole)) return;
  const Witness witness(whole, none, provenance, limits);
  auto made = timeAnswer(index, *found.duration, goal, found.evidence, witness);
  if (made.truth == Truth::True) answerKnown(index, std::move(made), found);
}

void Verification::answerKnown(std::size_t index, Answer made, const KnownAnswer& found) {
  if (checkpoint) settled.decided.push_back({index, found, {}});
  answer(index, std::move(made));
  known.insert(index);
  result.exploration.known = known.size();
}

bool Verification::wantsTrace(std::size_t index) const {
  return !options.wantsTrace || options.wantsTrace(index);
}

std::expected<Answer, std::string> Verification::shown(std::size_t index, const Goal& goal,
                                                       const Evidence& evidence,
                                                       const Witness& witness) const {
  return witness.answer(goal, evidence, wantsTrace(index));
}

/// \param shows the goal that the run of the evidence reaches; nothing if there is no run
Answer Verification::timeAnswer(std::size_t index, Duration time, const std::optional<Goal>& shows,
                                Evidence evidence, const Witness& witness) const {
  Answer made{.truth = Truth::True, .duration = time};
  if (!shows) return made;
  evidence.monitor = &shows->monitor;
  auto seen = shown(index, *shows, evidence, witness);
  if (!seen) return unknown("internal error, please report it: " + seen.error());
  made.trace = std::move(seen->trace);
  made.steps = seen->steps;
  return made;
}

} // namespace proskill::verify
