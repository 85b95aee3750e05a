#pragma once

#include "runtime/platform/file_error.h"
#include "runtime/platform/platform.h"

#include <expected>
#include <filesystem>
#include <functional>
#include <memory>

namespace proskill::runtime {

/// Settings of a program that performs the actions: docs/platforms.md.
struct ProcessSettings {
  std::vector<std::string> command;   ///< without a shell; the first word is looked up in PATH
  std::filesystem::path directory;    ///< working directory
  Nanoseconds startup = 10 * kSecond; ///< time that it has to become ready
  unsigned restarts = 0;              ///< how often it is restarted after it has ended
  Nanoseconds restartDelay = kSecond; ///< time before each restart
  double speed = 1;                   ///< of the run's clock
  std::vector<std::string> elsewhere; ///< skills whose actions somebody else performs
  std::string settings;               ///< JSON for `hello`; empty: none
  /// Its name in messages.
  std::string name = "the platform's program";
  bool isOurs = false; ///< it is `proskill` itself, whose error messages are whole sentences
  std::optional<FilePlace> place{}; ///< in the platform file, of what it loads
};

/// Why a platform cannot be used.
struct Unusable {
  std::string why;
  std::string skill; ///< the skill that it does not suit; empty if the error concerns the whole
                     ///< platform
};

/// Starts the program and waits until it is ready.
/// \pre the executable outlives the platform
/// \param givenUp asked regularly during the wait
[[nodiscard]] std::expected<std::unique_ptr<Platform>, Unusable>
processPlatform(const Executable& executable, ProcessSettings settings,
                const std::function<bool()>& givenUp);

} // namespace proskill::runtime
