#pragma once

#include "process/run.h"
#include "tina/backend.h"
#include "tina/workspace.h"

#include <chrono>

namespace proskill::tina {

/// Runs the tools one after the other in a workspace, within common limits.
class Session {
public:
  /// \pre the arguments outlive this
  Session(const Workspace& in, const Options& with) : workspace(in), options(with) {}

  /// Why a tool failed: a limit, which leaves answers unknown, or another reason.
  struct Stop {
    bool isLimit = false;
    std::string message;
  };
  /// Runs a tool and returns its output. \param name of the tool, for messages
  [[nodiscard]] std::expected<process::Finished, Stop> run(const std::string& name,
                                                           std::vector<std::string> command);
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  std::vector<Call> calls;

private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] process::Job job(const std::string& name, std::vector<std::string> command) const;
  [[nodiscard]] std::optional<Stop> judge(const std::string& name,
                                          const process::Finished& finished) const;

  const Workspace& workspace;
  const Options& options;
  Clock::time_point start = Clock::now();
};

} // namespace proskill::tina
