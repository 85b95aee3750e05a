#pragma once

#include <atomic>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace proskill::process {

/// A program that runs to its end without input; its output is collected.
struct Job {
  std::vector<std::string> command; ///< the first word is a path; no shell is involved
  std::filesystem::path directory;  ///< working directory
  std::optional<double> seconds;
  std::optional<std::uint64_t> memory; ///< bytes of address space for each of its processes
  std::uint64_t mostOutput = std::uint64_t{16}
                             << 20; ///< bytes; a program with more output is killed
  const std::atomic<bool>* cancelled = nullptr;
  /// Called a few times a second with the seconds so far and its last line of output.
  std::function<void(double, std::string_view)> progress;
};

enum class Ending : std::uint8_t { Exited, Signalled, TimedOut, Cancelled, TooMuchOutput };

struct Finished {
  Ending ending = Ending::Exited;
  int code = 0; ///< the exit code, or the number of the signal
  std::string out;
  std::string err;
  double seconds = 0;

  [[nodiscard]] bool succeeded() const { return ending == Ending::Exited && code == 0; }
  /// "ended with exit code 1", "was ended by signal 9 (Killed)".
  [[nodiscard]] std::string words() const;
};

/// Runs a program. On return, neither it nor any process that it started, directly or indirectly,
/// is running. The same holds if this process is killed. The error says why the program could not
/// be started.
[[nodiscard]] std::expected<Finished, std::string> run(const Job& job);

} // namespace proskill::process
