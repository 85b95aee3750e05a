#pragma once

#include "runtime/platform/platform.h"

#include <expected>
#include <filesystem>
#include <functional>
#include <memory>

namespace proskill::runtime {

/// A program that performs the actions: docs/platforms.md.
struct ProcessSettings {
  std::vector<std::string> command;   ///< without a shell; the first word is looked for on the PATH
  std::filesystem::path directory;    ///< where it runs
  Nanoseconds startup = 10 * kSecond; ///< how long it may take until it is ready
  unsigned restarts = 0;              ///< how often it is started again where it ends
  Nanoseconds restartDelay = kSecond; ///< and how long after that
  double speed = 1;                   ///< of the run's clock
  /// What messages call it.
  std::string name = "the platform's program";
  bool isOurs = false; ///< it is this program, and its complaints are whole sentences
};

/// Why a platform cannot be used.
struct Unusable {
  std::string why;
  std::string skill; ///< that it does not suit; empty: it is not about one
};

/// Starts the program and waits until it is ready. \pre the executable outlives the platform
/// \param givenUp asked now and then while this waits
[[nodiscard]] std::expected<std::unique_ptr<Platform>, Unusable>
processPlatform(const Executable& executable, ProcessSettings settings,
                const std::function<bool()>& givenUp);

} // namespace proskill::runtime
