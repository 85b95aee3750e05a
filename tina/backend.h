#pragma once

#include "tina/tools.h"
#include "verify/verify.h"

namespace proskill::tina {

/// The tool that runs now, for progress.
struct Progress {
  std::string tool;
  double seconds = 0;    ///< since this tool was started
  std::string_view line; ///< its last line of output
};

struct Options {
  Tools tools;
  std::optional<std::filesystem::path> keep; ///< a directory for all files, else a temporary one
  /// Time is that of all tools together, bytes are those of each; classes are given to the
  /// explorer.
  verify::Limits limits;
  const std::atomic<bool>* cancelled = nullptr;
  std::function<void(const Progress&)> progress;
};

/// A tool that was run.
struct Call {
  std::string command; ///< for people, not for a shell
  std::string ended;   ///< "ended with exit code 0"
  std::string out;
  std::string err;
};

struct Outcome {
  verify::Result result;
  std::string model; ///< the text that the tools were given
  std::vector<Call> calls;
};

/// Why there are no verdicts.
struct Failure {
  std::string message;
  std::string model;
  std::vector<Call> calls; ///< the last one is what went wrong
};

/// Answers the questions by Tina: frac, a compiler of C, sift or tina, selt; ktzio and the engine's
/// own replay for traces. Answers come from selt alone, with one exception: a property that
/// Fiacre cannot express, deadlocks of which some are allowed, is decided on the graph of Tina.
/// A limit that is met makes the answers unknown. Output of a tool that is not understood is a
/// failure.
[[nodiscard]] std::expected<Outcome, Failure> verify(const fiacre::Program& program,
                                                     const fiacre::Provenance& provenance,
                                                     const std::vector<verify::Question>& questions,
                                                     const Options& options);

/// The error, with the output of the last call, truncated if long.
[[nodiscard]] std::string explain(const Failure& failure);

} // namespace proskill::tina
