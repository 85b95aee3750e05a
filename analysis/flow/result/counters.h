#pragma once

#include "analysis/flow/engine/system.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace proskill::analysis::flow {

/// How far naturals are counted up. Who changes which one is collected once.
class Counters {
public:
  /// \pre the system outlives this
  explicit Counters(const System& system);

  /// The greatest value of a natural that is set to a number before a fork, and that only the
  /// branches of this fork count up. The solver lets each branch count any number of times; here, a
  /// branch counts as often as its longest path does. nullopt: the natural is changed otherwise, or
  /// a branch counts in a loop.
  [[nodiscard]] std::optional<std::int64_t> most(VariableId variable);

private:
  struct Changes {
    std::vector<ProcessId> counting;
    std::int64_t start = 0; ///< the greatest number to which it is set
    bool isOnlyCounted = true;
    std::optional<std::optional<std::int64_t>> most; ///< once it has been asked for
  };

  void collect(ProcessId process, const Assignment& assignment);

  const System& system;
  std::map<VariableId, Changes> changes;
};

} // namespace proskill::analysis::flow
