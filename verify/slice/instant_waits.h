#pragma once

#include "verify/limits.h"
#include "verify/model/system.h"
#include "verify/state/partial_evaluation.h"

#include <map>
#include <set>

namespace proskill::verify {

/// Finds conditions that are false only for an instant: while such a condition is false, an urgent
/// step is possible, so no time passes. An urgent step that waits for it can therefore be taken
/// before time passes, with or without the wait.
class InstantWaits {
public:
  /// \param system with its state layout \pre the arguments outlive this
  InstantWaits(const System& system, LimitWatch& limits);

  /// Whether some urgent transition is possible in each reachable state in which the condition is
  /// false. Conservative: may return false although it is so. \throw LimitMet
  [[nodiscard]] bool isInstant(NodeId condition);
  /// Whether the condition is true while the instance is at the location. Conservative: it must
  /// read one cell only, which no other instance writes. \throw LimitMet
  [[nodiscard]] bool holdsAt(NodeId condition, InstanceId instance, std::uint32_t location);

private:
  using CellValues = std::set<std::int64_t>;

  [[nodiscard]] bool isUrgentWith(const std::vector<CellId>& cells);
  [[nodiscard]] Bits locationsWith(InstanceId instance, CellId cell, std::int64_t value);
  [[nodiscard]] const std::vector<CellValues>& valuesAt(CellId cell);
  [[nodiscard]] bool someIsEnabled(InstanceId instance, std::uint32_t location);
  void set(CellId cell, std::int64_t value);
  void forget(CellId cell);

  const System& system;
  LimitWatch& limits;
  PartialEvaluation evaluation;
  std::vector<InstanceId> writer;           ///< by cell: the only instance that writes it, or kNone
  std::vector<std::vector<PathId>> pathsOf; ///< by instance
  std::vector<std::vector<TransitionId>> urgentOf; ///< by instance
  std::map<CellId, std::vector<CellValues>> known; ///< by location of the writer
  std::map<NodeId, bool> decided;
  std::vector<Word> state;
  std::vector<Word> unknown;
};

} // namespace proskill::verify
