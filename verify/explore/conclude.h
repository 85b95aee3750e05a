#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"

namespace proskill::verify {

/// Explores until the end or until a limit is met, and records the limit.
template <typename Explore> void exploreWithinLimits(Exploration& statistics, Explore explore) {
  try {
    explore();
  } catch (const LimitMet& limit) {
    statistics.stopped = limit.which;
  }
}

/// Records whether an exploration is complete, or why it stopped.
/// \param failure an error of the model; empty if there is none
/// \param otherwise the reason if neither a limit nor an error stopped it
inline void conclude(Exploration& statistics, bool isAtEnd, const std::string& failure,
                     const std::string& otherwise) {
  statistics.complete = isAtEnd && failure.empty() && statistics.stopped.empty();
  if (!statistics.complete && statistics.stopped.empty())
    statistics.stopped = failure.empty() ? otherwise : "an error of the model";
}

inline Answer unknown(std::string reason) {
  return {Truth::Unknown, std::nullopt, std::move(reason)};
}

/// The answer if an exploration has found no witness.
/// \param progressStopped why it is not known whether time can stop; may be empty
inline Answer answerWithoutEvidence(const Goal& goal, const Exploration& exploration,
                                    const std::string& progressStopped) {
  if (goal.kind == GoalKind::Unsupported) return unknown(goal.reason);
  if (!exploration.complete) return unknown(exploration.stopped);
  if (goal.kind == GoalKind::Stuck && !progressStopped.empty()) return unknown(progressStopped);
  return {Truth::True, std::nullopt, {}};
}

/// Makes the undecided questions inconclusive when a limit is met.
inline void giveUp(const LimitMet& limit, Result& result) {
  result.exploration.complete = false;
  result.exploration.stopped = limit.which;
  for (auto& answer : result.answers)
    if (answer.truth == Truth::Unknown && answer.reason.empty()) answer = unknown(limit.which);
}

} // namespace proskill::verify
