#pragma once

#include "runtime/executor/observer.h"

#include <vector>

namespace proskill::embed {

/// Passes on a run to several observers.
class Audience final : public runtime::Observer {
public:
  /// \pre it outlives this
  explicit Audience(runtime::Observer& with) : all{&with} {}
  /// \param other outlives what is passed on
  void add(runtime::Observer& other) { all.push_back(&other); }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, runtime::Nanoseconds date,
              runtime::Nanoseconds lag) override {
    for (auto* one : all) one->onStep(machine, step, date, lag);
  }
  void onRemark(const runtime::Remark& remark) override {
    for (auto* one : all) one->onRemark(remark);
  }

private:
  std::vector<runtime::Observer*> all;
};

} // namespace proskill::embed
