#include "analysis/program/stop.h"

#include <utility>

namespace proskill::analysis {

namespace {

/// What this thread works on; null where nobody can stop it.
thread_local const StopWhen* current = nullptr;

} // namespace

StopWhen::StopWhen(Question isUseless)
    : isUseless(std::move(isUseless)), outer(std::exchange(current, this)) {}

StopWhen::~StopWhen() { current = outer; }

void stopIfAsked() {
  if (current && current->isUseless()) throw Stopped();
}

} // namespace proskill::analysis
