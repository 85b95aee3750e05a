#include "verify/threads/thread_gain.h"

namespace proskill::verify {

void ThreadGain::add(double took, std::uint64_t done) {
  seconds += took;
  steps += done;
  const bool isFirst = preferred == 0;
  if (seconds < (isTrial || isFirst ? kTrial : kBetweenTrials)) return;
  const double speed = static_cast<double>(steps) / seconds;
  if (!isTrial) preferred = speed;
  if (isTrial && speed > preferred) prefersThreads = !prefersThreads;
  isTrial = !isTrial;
  seconds = 0;
  steps = 0;
}

} // namespace proskill::verify
