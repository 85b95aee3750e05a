#pragma once

#include "tina/tools.h"
#include "verify/verify.h"

namespace proskill::tina {

/// The running tool, for progress.
struct Progress {
  std::string tool;
  double seconds = 0;    ///< since this tool started
  std::string_view line; ///< its last line of output
};

struct Options {
  Tools tools;
  /// A directory for all files; nullopt: a temporary directory.
  std::optional<std::filesystem::path> keep;
  /// Time is for all tools together, memory for each tool; the limit of classes applies to the
  /// explorer.
  verify::Limits limits;
  const std::atomic<bool>* cancelled = nullptr;
  std::function<void(const Progress&)> progress;
};

/// A tool that has run.
struct Call {
  std::string command; ///< for users, not for a shell
  std::string ended;   ///< "ended with exit code 0"
  std::string out;
  std::string err;
};

struct Outcome {
  verify::Result result;
  std::string model; ///< the tools' input
  std::vector<Call> calls;
};

/// Why there are no verdicts.
struct Failure {
  std::string message;
  std::string model;
  std::vector<Call> calls; ///< the last one failed
};

/// Answers the questions with Tina: frac, a C compiler, sift or tina, selt; ktzio and the engine's
/// replay for traces. Answers come only from selt, with one exception: deadlock freedom with
/// allowed deadlocks, which Fiacre cannot express, is decided on Tina's state graph. If a limit is
/// met, answers are unknown. Unexpected output of a tool is a failure.
[[nodiscard]] std::expected<Outcome, Failure> verify(const fiacre::Program& program,
                                                     const fiacre::Provenance& provenance,
                                                     const std::vector<verify::Question>& questions,
                                                     const Options& options);

/// The error, with the output of the last call, truncated if long.
[[nodiscard]] std::string explain(const Failure& failure);

} // namespace proskill::tina
