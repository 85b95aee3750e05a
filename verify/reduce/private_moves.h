#pragma once

#include "verify/model/goals.h"
#include "verify/reduce/free_inputs.h"

#include <vector>

namespace proskill::verify {

/// Steps of a process on free inputs that only this process reads, from a location where it does
/// nothing else, to one where it may stay for ever: as a monitor's that waits for its alarm to end
/// and then for the next one. Whatever the others do before such a step they can do behind it, so
/// it may be taken at once.
class PrivateMoves {
public:
  /// \param dropped transitions that are left out \pre the arguments outlive this
  PrivateMoves(const System& system, const std::vector<Goal>& goals, const Bits& dropped,
               const FreeInputs& inputs);

  [[nodiscard]] bool none() const { return movers.empty(); }

  /// Such a step that is possible with some values of the free inputs; kNone where there is none.
  [[nodiscard]] TransitionId pick(const Word* state) const;

private:
  /// A process with such steps.
  struct Mover {
    CellId location = 0;
    std::vector<TransitionId> moves;   ///< by location; kNone where there is none
    std::vector<std::uint32_t> inputs; ///< those that only it reads
  };

  const System& system;
  const FreeInputs& inputs;
  std::vector<Mover> movers;
};

} // namespace proskill::verify
