#pragma once

#include <functional>
#include <string>
#include <vector>

namespace proskill::test {

/// The result of a program that has ended.
struct Finished {
  int exitCode = -1; ///< 128 + the signal if one ended it
  std::string out;
  std::string err;
  long peakKiB = 0; ///< largest resident set
};

struct RunOptions {
  std::string input;
  std::vector<std::string> environment; ///< `NAME=value`, in addition to this process's own
  /// Called with the process's id after the first byte of output on either stream.
  std::function<void(int)> onOutput;
};

/// Runs a program to its end, without a shell. Throws if it cannot be started.
[[nodiscard]] Finished run(const std::vector<std::string>& command, const RunOptions& options = {});

/// A temporary directory, removed by the destructor.
class TemporaryDirectory {
public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  [[nodiscard]] std::string path(const std::string& name = "") const;
  /// Writes a file, and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

private:
  std::string root;
};

} // namespace proskill::test
