#include "verify/verification.h"

/// How questions about runs are answered: by slices and short searches while the search of states
/// is long, and otherwise by a search of their own after it.
namespace proskill::verify {

namespace {

/// How many classes the slices for a question about runs may have, compared with those for a
/// question about states. There are few such questions, and no other search decides them.
constexpr std::uint64_t kRunsPerState = 4;

} // namespace

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
