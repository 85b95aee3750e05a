#pragma once

#include "verify/slice/slicer.h"
#include "verify/state/run.h"

#include <vector>

namespace proskill::verify {

/// Follows a run of a slice from the initial state of the whole, and looks at the conditions of its
/// steps that the slice omits.
class OmittedConditions {
public:
  /// \param known cells of conditions that the slice does not omit
  /// \pre the arguments outlive this
  OmittedConditions(const Slicer& slicer, const Bits& known);

  /// \param step the next one, in the slicer's system
  void follow(TransitionId step);

  /// The cells that the next slice should know: those about which two instances are in conflict, as
  /// about a resource that both take; or else those that others have to change, of the conditions
  /// that are closest to the end of the run. Empty: the run lacks nothing but dates.
  [[nodiscard]] Bits wanted() const;

private:
  void look(const Condition& condition, InstanceId reader);
  [[nodiscard]] bool isWrittenByAnother(const Bits& cells, InstanceId reader) const;

  const Slicer& slicer;
  const System& system;
  const Bits& known;
  std::vector<Word> state;
  std::vector<InstanceId> writer; ///< by cell: the last one; kNone: it has its initial value
  StepLog log;
  bool isLost = false;       ///< a step was not possible, so the values are not known any more
  Bits inConflict;           ///< cells of the first false condition of this kind
  std::vector<Bits> ofFalse; ///< by false condition, in their order
};

} // namespace proskill::verify
