#pragma once

#include "tina/tools.h"
#include "verify/verify.h"

namespace proskill::tina {

/// What runs now, for whoever waits.
struct Progress {
  std::string tool;
  double seconds = 0;    ///< since this tool was started
  std::string_view line; ///< the last that it said
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
/// own replay for traces. An answer comes from selt alone; only where the property is one that
/// Fiacre has no words for, deadlocks of which some are allowed, from the graph that Tina made. A
/// limit that is met makes the answers unknown. What a tool says that is not understood is a
/// failure.
[[nodiscard]] std::expected<Outcome, Failure> verify(const fiacre::Program& program,
                                                     const fiacre::Provenance& provenance,
                                                     const std::vector<verify::Question>& questions,
                                                     const Options& options);

/// What went wrong, with the last call's output, cut where it is long.
[[nodiscard]] std::string explain(const Failure& failure);

} // namespace proskill::tina
