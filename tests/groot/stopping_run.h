#pragma once

#include "groot/hooks.h"
#include "runtime/executor/execution.h"
#include "tests/groot/watched_run.h"

#include <nlohmann/json.hpp>

namespace proskill::test {

/// A run in simulated time that stops at breakpoints, and what viewers hear of it.
class StoppingRun {
public:
  explicit StoppingRun(const std::string& text, bool mayStop = true);

  /// Goes on until the run is paused or has ended. \return whether it is paused
  bool goOn();
  /// The uids of the messages since the last call: `2 5`.
  [[nodiscard]] std::string heard();
  [[nodiscard]] std::string value(std::string_view variable) const;
  [[nodiscard]] std::uint64_t steps() const { return execution.result().steps; }
  [[nodiscard]] runtime::Nanoseconds date() const { return execution.now(); }
  /// The only node with this tag.
  [[nodiscard]] groot::Uid uid(std::string_view tag) const;

  [[nodiscard]] std::string insert(std::string_view tag, groot::Position position,
                                   bool isOnce = false);
  [[nodiscard]] std::string unlock(std::string_view tag, groot::Position position,
                                   const std::string& desired = "SKIPPED");
  [[nodiscard]] std::string remove(std::string_view tag, groot::Position position);

  WatchedRun it;
  runtime::Pause pause;
  groot::Breakpoints breakpoints;
  std::string messages;
  groot::Hooks hooks;

private:
  std::unique_ptr<runtime::Clock> clock;
  std::unique_ptr<runtime::Platform> platform;
  std::unique_ptr<runtime::Observer> observer;
  runtime::Execution execution;
};

} // namespace proskill::test
