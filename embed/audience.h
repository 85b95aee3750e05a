#pragma once

#include "runtime/executor/observer.h"

namespace proskill::embed {

/// Passes on a run to one or two observers.
class Audience final : public runtime::Observer {
public:
  /// \pre it outlives this
  explicit Audience(runtime::Observer& with) : first(with) {}
  /// \param other outlives what is passed on
  void add(runtime::Observer& other) { second = &other; }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, runtime::Nanoseconds date,
              runtime::Nanoseconds lag) override {
    first.onStep(machine, step, date, lag);
    if (second) second->onStep(machine, step, date, lag);
  }
  void onRemark(const runtime::Remark& remark) override {
    first.onRemark(remark);
    if (second) second->onRemark(remark);
  }

private:
  runtime::Observer& first;
  runtime::Observer* second = nullptr;
};

} // namespace proskill::embed
