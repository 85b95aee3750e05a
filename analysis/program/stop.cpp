#include "analysis/program/stop.h"

#include <utility>

namespace proskill::analysis {

namespace {

/// What this thread works on; null where nobody can stop it.
thread_local const StopWhen* current = nullptr;

/// The thread sanitizer's `pthread_once` never ends after an exception; with the others, the next
/// who asks computes what was stopped.
#ifdef __SANITIZE_THREAD__
constexpr bool kStops = false;
#else
constexpr bool kStops = true;
#endif

} // namespace

StopWhen::StopWhen(Question isUseless)
    : isUseless(std::move(isUseless)), outer(std::exchange(current, this)) {}

StopWhen::~StopWhen() { current = outer; }

void stopIfAsked() {
  if (kStops && current && current->isUseless()) throw Stopped();
}

} // namespace proskill::analysis
