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

/// Why there is no report. A failure of the process is an error, never a verdict.
struct WorkerFailure {
  bool cancelled = false;
  std::string message;
};

/// Receives the partial report and the properties decided since the last call; undecided ones are
/// inconclusive in it.
using OnSoFar =
    std::function<void(const OrderedJson& report, const std::vector<std::size_t>& rows)>;

/// Runs a job in a process of its own and waits for its report (docs/verify.schema.json). The
/// process has ended when this returns. If it ends too early, the report has its decisions,
/// and the rest is inconclusive.
/// \param command the program that runs `runVerifyWorker`, and its arguments
/// \param onSoFar called at most once a second, after new decisions; may be empty
[[nodiscard]] std::expected<OrderedJson, WorkerFailure>
runWorker(const std::vector<std::string>& command, const WorkerJob& job,
          const rpc::Cancellation& cancellation,
          const std::function<void(const WorkerProgress&)>& progress, const OnSoFar& onSoFar = {});

} // namespace proskill::worker
