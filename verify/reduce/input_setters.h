#pragma once

#include "verify/model/goals.h"

#include <optional>
#include <vector>

/// Finds variables that the environment may change at any time between certain values.
namespace proskill::verify {

/// The first step on a path from one value of a free input to another.
struct InputMove {
  TransitionId setter = kNone;
  std::int64_t next = 0; ///< the value after this step
};

struct FreeInput {
  CellId cell = 0;
  /// Each value can be changed to any other; the first one is the representative.
  std::vector<std::int64_t> values;
  std::vector<TransitionId> setters; ///< setters between these values only
  /// [value - the cell's lowest value][index of the target value]: first step of a shortest path.
  std::vector<std::vector<InputMove>> moves;
  std::vector<Word> readers; ///< transitions whose guard reads it
};

/// \pre the system has a state layout
/// \param dropped transitions that are skipped
[[nodiscard]] std::vector<FreeInput>
findFreeInputs(const System& system, const std::vector<Goal>& goals, const Bits& dropped);

} // namespace proskill::verify
