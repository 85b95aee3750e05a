#pragma once

#include "analysis/flow/engine/system.h"

#include <vector>

namespace proskill::analysis::flow {

/// How processes may end or delay others at any moment. What this needs of all processes is
/// collected once.
class Disturbances {
public:
  /// \pre the system outlives this
  explicit Disturbances(const System& system);

  /// The nodes of the guards of a process.
  [[nodiscard]] const std::vector<NodeId>& guardsOf(ProcessId process) const {
    return guards[process];
  }
  /// Whether others may end the thread at once: by a guard of a caller, by a parallel branch that
  /// ends the skill or wins a race, or by an interrupt.
  [[nodiscard]] bool mayBeEnded(ProcessId thread) const;
  /// Whether others may delay the call: they call the same skill, or hold what it needs.
  [[nodiscard]] bool mayBeHeldUp(ProcessId caller, ProcessId callee) const;

private:
  struct Interrupt {
    ProcessId by = kNoProcess;
    ProcessId of = kNoProcess;
  };

  void collect(ProcessId process);
  [[nodiscard]] IdSet threadsAround(ProcessId thread) const;
  [[nodiscard]] bool racesWith(ProcessId branch, const IdSet& threads) const;

  const System& system;
  std::vector<std::vector<NodeId>> guards; ///< by process
  std::vector<Interrupt> interrupts;
  std::vector<ProcessId> guarded;
  std::vector<ProcessId> leaving;  ///< branches that may end their skill
  std::vector<ProcessId> branches; ///< of races
};

} // namespace proskill::analysis::flow
