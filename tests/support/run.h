#pragma once

#include <functional>
#include <string>
#include <vector>

namespace proskill::test {

/// What a finished program left behind.
struct Finished {
  int exitCode = -1; ///< 128 + the signal where one ended it
  std::string out;
  std::string err;
  long peakKiB = 0; ///< largest resident set
};

struct RunOptions {
  std::string input;
  std::vector<std::string> environment; ///< `NAME=value`, added to this process's own
  /// Called once when the first byte has come out on either stream, with the process's id.
  std::function<void(int)> onOutput;
};

/// Runs a program to its end, without a shell. Throws where it cannot be started.
[[nodiscard]] Finished run(const std::vector<std::string>& command, const RunOptions& options = {});

/// A directory of its own, gone with the object.
class TemporaryDirectory {
public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  [[nodiscard]] std::string path(const std::string& name = "") const;
  /// Writes a file, and gives its path.
  std::string write(const std::string& name, const std::string& text) const;

private:
  std::string root;
};

} // namespace proskill::test
