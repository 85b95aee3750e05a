#pragma once

#include "verify/model/goals.h"
#include "verify/reduce/free_inputs.h"

#include <vector>

namespace proskill::verify {

/// Fires certain steps at once: steps of a process that read only free inputs of this process
/// alone, leave a location in which it does nothing else, and reach a location in which it may stay
/// for ever. Example: a monitor that waits until its alarm ends, then for the next alarm. Whatever
/// other processes do before such a step, they can also do after it.
class PrivateMoves {
public:
  /// \param dropped transitions that are skipped
  /// \pre the arguments outlive this
  PrivateMoves(const System& system, const std::vector<Goal>& goals, const Bits& dropped,
               const FreeInputs& inputs);

  [[nodiscard]] bool none() const { return movers.empty(); }

  /// Such a step that is possible for some values of the free inputs; kNone if there is none.
  [[nodiscard]] TransitionId pick(const Word* state) const;

private:
  /// A process with such steps.
  struct Mover {
    CellId location = 0;
    std::vector<TransitionId> moves;   ///< by location; kNone where there is none
    std::vector<std::uint32_t> inputs; ///< indices of the inputs that only this process reads
  };

  const System& system;
  const FreeInputs& inputs;
  std::vector<Mover> movers;
};

} // namespace proskill::verify
