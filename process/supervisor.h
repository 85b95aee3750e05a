#pragma once

#include <cstdint>
#include <optional>

#include <sys/types.h>

namespace proskill::process {

/// The program that the supervisor starts, and its ends of the pipes.
struct Supervised {
  char* const* arguments = nullptr;
  const char* directory = nullptr;
  std::optional<std::uint64_t> memory; ///< bytes
  int out = -1;
  int err = -1;
  int report = -1; ///< receives `Report`s
};

/// The errno of a program that did not start, or the status that waitpid returned.
struct Report {
  int error = 0;
  int status = 0;
};

/// Main function of a process between this one and a program: starts the program, waits for its end
/// or for SIGTERM, which also comes when `parent` ends, and kills all remaining processes that the
/// program started. Call it after a fork with SIGTERM and SIGCHLD blocked. It calls only
/// async-signal-safe functions and does not return.
[[noreturn]] void supervise(const Supervised& program, pid_t parent);

} // namespace proskill::process
