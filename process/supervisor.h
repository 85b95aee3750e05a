#pragma once

#include <cstdint>
#include <optional>

#include <sys/types.h>

namespace proskill::process {

/// What the supervisor starts, and the ends of pipes that it gives it.
struct Supervised {
  char* const* arguments = nullptr;
  const char* directory = nullptr;
  std::optional<std::uint64_t> memory; ///< bytes
  int out = -1;
  int err = -1;
  int report = -1; ///< where `Report`s are written
};

/// Either a program that did not start, with errno, or its status as waitpid gives it.
struct Report {
  int error = 0;
  int status = 0;
};

/// Main function of a process between us and a program: starts it, waits for its end or for
/// SIGTERM, which also comes when `parent` ends, and kills all that is left of what the program
/// started. To be called after a fork, with SIGTERM and SIGCHLD blocked; calls only what is allowed
/// then, and does not return.
[[noreturn]] void supervise(const Supervised& program, pid_t parent);

} // namespace proskill::process
