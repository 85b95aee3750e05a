#pragma once

#include "report/ordered_json.h"
#include "report/report_json.h"
#include "rpc/scheduler.h"
#include "worker/worker_job.h"

#include <functional>

namespace proskill::worker {

/// What a verification reports while it runs.
struct WorkerProgress {
  std::uint64_t decided = 0; ///< of `total` properties
  std::uint64_t total = 0;
  std::uint64_t classes = 0;
  std::uint64_t markings = 0;
  std::uint64_t waiting = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;

  [[nodiscard]] double rate() const { ///< classes a second
    return seconds > 0 ? static_cast<double>(classes) / seconds : 0;
  }
};

/// Why there is no report. What went wrong with the process is an error, and never a verdict.
struct WorkerFailure {
  bool cancelled = false;
  std::string message;
};

/// Gets the report as far as it is known, and which of its properties were decided since the last
/// time; what is not decided yet is inconclusive in it.
using OnSoFar =
    std::function<void(const OrderedJson& report, const std::vector<std::size_t>& rows)>;

/// Runs a job in a process of its own and waits for its report (docs/verify.schema.json). The
/// process has ended when this returns. Where it ends too early, what it has decided is in the
/// report, and the rest of it inconclusive.
/// \param command the program that runs `runVerifyWorker`, and its arguments
/// \param onSoFar called at most once a second, where something was decided since; may be empty
[[nodiscard]] std::expected<OrderedJson, WorkerFailure>
runWorker(const std::vector<std::string>& command, const WorkerJob& job,
          const rpc::Cancellation& cancellation,
          const std::function<void(const WorkerProgress&)>& progress, const OnSoFar& onSoFar = {});

} // namespace proskill::worker
