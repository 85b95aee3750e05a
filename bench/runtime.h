#pragma once

#include "runtime/executor/executor.h"
#include "runtime/machine/executable.h"

#include <fmt/format.h>

#include <cstdlib>

namespace proskill::bench {

/// Latency, lateness and processor time with a real clock, against a loop that polls every 10 ms.
void measureRealTime();

[[nodiscard]] inline std::unique_ptr<const runtime::Executable>
executableOf(const analysis::Program& program, bool environment = true) {
  auto made = runtime::makeExecutable(program, "", environment);
  if (made) return std::move(*made);
  fmt::print("{}\n", made.error().message);
  std::exit(1);
}

/// Ignores everything.
class Deaf : public runtime::Observer {
public:
  void onStep(const runtime::Machine&, verify::TransitionId, runtime::Nanoseconds,
              runtime::Nanoseconds) override {}
  void onRemark(const runtime::Remark&) override {}
};

} // namespace proskill::bench
