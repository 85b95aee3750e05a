#pragma once

#include "analysis/flow/result/unrolled.h"
#include "syntax/text/rational.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::analysis::flow {

/// An interval of time in seconds with closed bounds.
struct Duration {
  syntax::Rational least;
  std::optional<syntax::Rational> most; ///< nullopt: no bound is known
};

/// "5 s", "5 to 35 s", "at least 5 s".
[[nodiscard]] std::string words(const Duration& duration);

/// Computes how long skills take, from their parts: sequences, branches, parallel branches, loops
/// that count.
class Durations {
public:
  explicit Durations(const Solver& solver);

  /// The duration of a process in runs without a stop; nothing if it cannot end. `least` is never
  /// too large. `most` is never too small, also for runs that are stopped.
  [[nodiscard]] std::optional<Duration> of(ProcessId process);
  /// Whether something may interrupt it, or a guard of its own may fail.
  [[nodiscard]] bool mayEndEarly(ProcessId skill) const;
  /// The duration of one visit of a node.
  [[nodiscard]] Duration ofNode(ProcessId process, NodeId node);

private:
  using Date = std::optional<syntax::Rational>;

  void compute(ProcessId process);
  [[nodiscard]] bool isReady(ProcessId process, std::vector<ProcessId>& needed) const;
  [[nodiscard]] Duration ofCall(ProcessId process, NodeId node);
  [[nodiscard]] Duration ofFork(ProcessId process, NodeId node);
  [[nodiscard]] Duration ofRace(ProcessId process, NodeId node);
  [[nodiscard]] bool mayHoldOut(ProcessId branch) const;
  [[nodiscard]] bool mayBeAwaited(ProcessId caller, ProcessId callee) const;
  [[nodiscard]] static Date earliestEnd(const Unrolled& ways, const std::vector<Duration>& times);
  [[nodiscard]] static Date latestExit(const Unrolled& ways, const std::vector<Duration>& times);

  /// The results for a process.
  struct Known {
    std::optional<Duration> whole; ///< until its end; nothing if it cannot end
    Date latestExit;               ///< including exits where a branch ends its skill
  };

  const Solver& solver;
  const System& system;
  std::vector<std::optional<Known>> known;
  std::vector<bool> busy; ///< being computed; another check reports recursion
};

} // namespace proskill::analysis::flow
