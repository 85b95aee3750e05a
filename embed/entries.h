#pragma once

#include "embed/program.h"
#include "runtime/executor/observer.h"

#include <string>
#include <utility>

namespace proskill::embed {

/// Reports a run to an observer of another program.
class Entries final : public runtime::Observer {
public:
  /// \pre the arguments outlive this
  Entries(const analysis::Program& of, const runtime::Executable& by, proskill_executor* owner)
      : program(of), executable(by), owner(owner) {}

  void observe(proskill_observer with, void* its) {
    observer = with;
    data = its;
  }
  [[nodiscard]] bool hasTrouble() const { return !trouble.empty(); }
  /// What an observer has thrown; empty: nothing. Forgets it.
  [[nodiscard]] std::string takeTrouble() { return std::exchange(trouble, {}); }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, runtime::Nanoseconds date,
              runtime::Nanoseconds lag) override;
  void onRemark(const runtime::Remark& remark) override;

private:
  void report(proskill_entry entry, fiacre::OriginId origin);

  const analysis::Program& program;
  const runtime::Executable& executable;
  proskill_executor* owner;
  proskill_observer observer = nullptr;
  void* data = nullptr;
  std::string trouble;
};

} // namespace proskill::embed
