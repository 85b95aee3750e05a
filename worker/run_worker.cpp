#include "worker/run_worker.h"

#include "process/child.h"
#include "report/ordered_json.h"

#include <fmt/format.h>

#include <unistd.h>

namespace proskill::worker {

namespace {

using Clock = std::chrono::steady_clock;

/// Interval at which cancellation is checked while no output comes.
constexpr std::chrono::milliseconds kPatience{10};
/// Interval at which partial reports are sent.
constexpr std::chrono::seconds kBetweenReports{1};
/// Time beyond the budget for everything but the exploration: reading, compiling, making traces.
constexpr double kGraceSeconds = 10;

WorkerProgress progressOf(const OrderedJson& json) {
  WorkerProgress progress;
  progress.decided = json.value("decided", std::uint64_t{0});
  progress.total = json.value("total", std::uint64_t{0});
  progress.classes = json.value("classes", std::uint64_t{0});
  progress.markings = json.value("markings", std::uint64_t{0});
  progress.waiting = json.value("waiting", std::uint64_t{0});
  progress.bytes = json.value("bytes", std::uint64_t{0});
  progress.seconds = json.value("seconds", 0.0);
  return progress;
}

/// One conversation with a worker.
class Conversation {
public:
  using Result = std::expected<OrderedJson, WorkerFailure>;

  Conversation(process::Child& with, const std::function<void(const WorkerProgress&)>& tell,
               const OnSoFar& tellSoFar)
      : child(with), progress(tell), onSoFar(tellSoFar) {}

  Result hold(std::string_view toSend, const rpc::Cancellation& cancellation, double seconds) {
    const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
    while (!result) {
      if (cancellation.isCancelled()) return std::unexpected(WorkerFailure{true, "cancelled"});
      if (Clock::now() > deadline)
        return soFarOr("the verification exceeded its time limit and was stopped");
      auto done = child.exchange(toSend, kPatience);
      toSend.remove_prefix(done.sent);
      hear(done.received);
      if (!result) handOver();
      if (done.ended && !result)
        return soFarOr("the process that verifies gave no answer: " + child.ending());
    }
    return std::move(*result);
  }

private:
  void handOver() {
    if (!onSoFar || fresh.empty() || Clock::now() < nextReport) return;
    nextReport = Clock::now() + kBetweenReports;
    onSoFar(soFar, std::exchange(fresh, {}));
  }

  void hear(std::string_view bytes) {
    while (!bytes.empty() && !result) {
      const auto end = bytes.find('\n');
      line += bytes.substr(0, end);
      if (end == std::string_view::npos) return;
      understand(OrderedJson::parse(std::exchange(line, {}), nullptr, false));
      bytes.remove_prefix(end + 1);
    }
  }

  void understand(OrderedJson message) {
    if (!message.is_object()) return fail("the verifying process sent an invalid message");
    if (message.contains("progress")) {
      if (progress) progress(progressOf(message["progress"]));
    } else if (message.contains("begin")) {
      soFar = std::move(message["begin"]);
    } else if (message.contains("decided")) {
      const auto index = message["decided"].value("index", std::size_t{0});
      auto& rows = soFar["properties"];
      if (index < rows.size()) rows[index] = std::move(message["decided"]["property"]);
      anyDecided = true;
      fresh.push_back(index);
    } else if (message.contains("report")) {
      result = completed(std::move(message["report"]));
    } else if (message.contains("stopped")) {
      result = soFarOr(message.value("stopped", ""));
    } else {
      fail(message.value("error", "the process that verifies gave an answer without a report"));
    }
  }

  /// Fills in the verdicts that were sent before in place of null.
  OrderedJson completed(OrderedJson report) {
    auto& told = soFar["properties"];
    auto& rows = report["properties"];
    for (std::size_t i = 0; i < rows.size() && i < told.size(); ++i)
      if (rows[i].is_null()) rows[i] = std::move(told[i]);
    return report;
  }

  /// The verdicts so far, with the rest inconclusive for this reason; only the reason if there are
  /// none.
  Result soFarOr(std::string reason) {
    if (!anyDecided) return std::unexpected(WorkerFailure{false, std::move(reason)});
    for (auto& row : soFar["properties"])
      if (row.value("verdict", "") == "inconclusive") row["reason"] = reason;
    soFar["exploration"]["stopped"] = reason;
    return std::move(soFar);
  }

  void fail(std::string message) {
    result = std::unexpected(WorkerFailure{false, std::move(message)});
  }

  process::Child& child;
  const std::function<void(const WorkerProgress&)>& progress;
  const OnSoFar& onSoFar;
  Clock::time_point nextReport = Clock::now() + kBetweenReports;
  std::string line;  ///< received so far
  OrderedJson soFar; ///< the report so far
  bool anyDecided = false;
  std::vector<std::size_t> fresh; ///< decided since the last partial report
  std::optional<Result> result;
};

} // namespace

std::expected<OrderedJson, WorkerFailure>
runWorker(const std::vector<std::string>& command, const WorkerJob& job,
          const rpc::Cancellation& cancellation,
          const std::function<void(const WorkerProgress&)>& progress, const OnSoFar& onSoFar) {
  if (cancellation.isCancelled()) return std::unexpected(WorkerFailure{true, "cancelled"});
  auto child = process::Child::start(command);
  if (!child)
    return std::unexpected(
        WorkerFailure{false, "the process that verifies could not be started: " + child.error()});
  return Conversation(*child, progress, onSoFar)
      .hold(encode(job, getpid()), cancellation, job.budget.seconds + kGraceSeconds);
}

} // namespace proskill::worker
