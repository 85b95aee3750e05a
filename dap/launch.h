#pragma once

#include "dap/source.h"

#include "analysis/program/file_system.h"
#include "worker/run_worker.h"

namespace proskill::dap {

/// The arguments of `launch`, described in docs/dap.md.
struct LaunchArguments {
  std::filesystem::path program; ///< empty: only a trace file
  std::string property;
  std::filesystem::path trace;
  std::optional<double> from; ///< of a long recording: seconds since the start of the run
  bool simulate = false;
  std::string mainSkill;
  std::filesystem::path directory; ///< base of relative paths
  bool stopOnEntry = true;
  worker::Budget budget;
};

/// The error is a message.
[[nodiscard]] std::expected<LaunchArguments, std::string> readLaunch(const Json& json);

struct LaunchContext {
  const analysis::FileSystem& disk;
  const std::vector<std::string>& worker; ///< the command that runs `lsp::runVerifyWorker`
  rpc::Cancellation cancellation;
  std::function<void(const worker::WorkerProgress&)> progress;
  std::function<void(const std::string&)> note; ///< shows the user a message
};

/// Creates the source of a session's steps: a trace file, a simulation, or the verification of a
/// property.
[[nodiscard]] std::expected<std::unique_ptr<StepSource>, std::string>
openSource(const LaunchArguments& arguments, const LaunchContext& surroundings);

} // namespace proskill::dap
