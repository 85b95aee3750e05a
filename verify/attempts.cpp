#include "verify/sample/random_runs.h"
#include "verify/sample/shortened.h"
#include "verify/verification.h"

#include <algorithm>
#include <iterator>
#include <utility>

/// What else is tried while the search of states is long: random runs, and searches in other
/// orders. Questions about runs are answered by slices and short searches then, and otherwise by a
/// search of their own after it.
namespace proskill::verify {

namespace {

/// How many classes the slices for a question about runs may have, compared with those for a
/// question about states. There are few such questions, and no other search decides them.
constexpr std::uint64_t kRunsPerState = 4;

/// Steps of trials by which the random runs of a stage become shorter: about a second.
constexpr std::uint64_t kMostShortening = 500'000;
/// Steps of their traces, since other searches find shorter ones. More take longer than the runs.
constexpr std::uint64_t kMostTraced = 50'000;

} // namespace

std::vector<std::size_t> Verification::openAmong(const std::vector<std::size_t>& which,
                                                 const auto& suits) const {
  std::vector<std::size_t> open;
  std::ranges::copy_if(which, std::back_inserter(open),
                       [&](std::size_t i) { return !answered.contains(i) && suits(i); });
  return open;
}

/// Looks for goals that lie deep, by a short search for each question, states closest to the goal
/// first. \return whether any of the questions was answered
/// \param most number of classes of all searches together
/// \param each the fewest classes of one
bool Verification::exploreLed(const std::vector<std::size_t>& which, std::uint64_t most,
                              std::uint64_t each) {
  const auto before = answered.size();
  const auto left = leadable(which);
  if (left.empty() || left.size() * whole.transitions.size() > kMostLedWork) return false;
  const auto share = most / left.size();
  if (share == 0 || share < each) return false;
  for (auto i : left) exploreWhole({i}, {.at = {share}, .next = {}}, Order::Led);
  return answered.size() > before;
}

/// Looks for all goals at once by random runs. \return whether any of the questions was answered
/// \param most steps without a finding after which it ends
/// \param traced whether it answers the questions that want a trace, or the others
bool Verification::sampleRuns(const std::vector<std::size_t>& which, std::uint64_t most,
                              bool traced) {
  const auto left = openAmong(which, [&](std::size_t i) {
    return GoalIndex::isFor(compiled.goals[i]) && wantsTrace(i) == traced;
  });
  if (left.empty() || most == 0) return false;
  const Witness witness(whole, none, provenance, limits);
  const auto before = answered.size();
  std::uint64_t effort = kMostShortening;
  std::uint64_t shown = 0;
  RandomRuns(whole, witness.enablingOfAll(), compiled.goals, left, limits)
      .search(most, [&](std::size_t i, const Evidence& evidence) {
        if (!traced) return isShownBySlice(i, &evidence, witness);
        const auto& goal = compiled.goals[i];
        if (shown > kMostTraced || !witness.refutation(goal, evidence).empty()) return false;
        const auto shorter = shortened(whole, goal, evidence, witness, effort);
        shown += shorter.steps.size();
        answerBy(i, shorter, witness);
        return true;
      });
  return answered.size() > before;
}

/// Looks for all goals at once, new states first. \return whether any of the questions was answered
/// \param most number of classes after which it ends, unless some of them have led to an answer
bool Verification::exploreNewest(const std::vector<std::size_t>& which, std::uint64_t most) {
  const auto before = answered.size();
  const auto left =
      openAmong(which, [&](std::size_t i) { return Slicer::canDecide(compiled.goals[i]); });
  if (left.empty() || most == 0) return false;
  auto last = before;
  std::uint64_t until = most;
  const auto next = [&]() -> std::optional<SearchSize> {
    if (answered.size() == std::exchange(last, answered.size())) return std::nullopt;
    return SearchSize{.classes = until += most};
  };
  exploreWhole(left, {.at = {most}, .next = next}, Order::Newest);
  return answered.size() > before;
}

/// Looks for all goals at once, wherever random walks lead. \return whether any of the questions
/// was answered
/// \param most number of classes
bool Verification::exploreByWalks(const std::vector<std::size_t>& which, std::uint64_t most) {
  const auto before = answered.size();
  const auto left = leadable(which);
  if (left.empty() || most == 0) return false;
  exploreWhole(left, {.at = {most}, .next = {}}, Order::Walks);
  return answered.size() > before;
}

/// The open questions among these to which a search can be led.
std::vector<std::size_t> Verification::leadable(const std::vector<std::size_t>& which) const {
  return openAmong(which, [&](std::size_t i) { return GoalDistance::isFor(compiled.goals[i]); });
}

std::optional<Unsupported> Verification::watch(std::size_t index, const Goal& goal) {
  if (mayRefineRuns(goal) && usesParts()) {
    const auto stages = stagesOf(options);
    if (auto failure = watchWithin(index, stages[2].at.classes)) return failure;
    if (answered.contains(index) ||
        isShownByRunSlices(index, kRunsPerState * stages[2].refined.each))
      return std::nullopt;
  }
  return watchWithin(index, UINT64_MAX);
}

bool Verification::mayRefineRuns(const Goal& goal) const {
  return takes(Reduction::Refinement) && RunProof::isFor(goal);
}

/// \return whether slices have answered the question
/// \param most number of classes
bool Verification::isShownByRunSlices(std::size_t index, std::uint64_t most) {
  const Goal& goal = compiled.goals[index];
  if (most == 0 || !mayRefineRuns(goal) ||
      !refinementOfAll().showNoRun(goal, most, result.exploration))
    return false;
  ++result.exploration.sliced;
  return answerTrue(index);
}

/// Asks slices about runs, and searches a part of the whole. Otherwise these questions would wait
/// for the end of the search of states.
void Verification::exploreRuns(const Stage& reached) {
  if (reached.refined.each == 0) return;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < compiled.goals.size(); ++i)
    if (compiled.goals[i].kind == GoalKind::Run && !answered.contains(i)) open.push_back(i);
  const bool isLong = stage > 2; // otherwise the search of states may be over soon
  for (auto i : open)
    if (!isShownByRunSlices(i, kRunsPerState * reached.refined.each) && isLong)
      (void)watchWithin(i, reached.at.classes / open.size());
}

} // namespace proskill::verify
