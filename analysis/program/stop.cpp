#include "analysis/program/stop.h"

#include <utility>

namespace proskill::analysis {

namespace {

/// the work of this thread; null if it cannot be stopped
thread_local const StopWhen* current = nullptr;

} // namespace

StopWhen::StopWhen(Question isUseless)
    : isUseless(std::move(isUseless)), outer(std::exchange(current, this)) {}

StopWhen::~StopWhen() { current = outer; }

void stopIfAsked() {
  if (current && current->isUseless()) throw Stopped();
}

} // namespace proskill::analysis
