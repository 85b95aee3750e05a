#pragma once

#include "verify/model/goals.h"

#include <optional>
#include <vector>

/// Which variables the environment may change at any time, from each of some values to each other.
namespace proskill::verify {

/// A step that leads from one value of a free input to the next on the way to another.
struct InputMove {
  TransitionId setter = kNone;
  std::int64_t next = 0; ///< the value behind it
};

struct FreeInput {
  CellId cell = 0;
  std::vector<std::int64_t> values;  ///< each reaches each; the first stands for all
  std::vector<TransitionId> setters; ///< they lead from these values to these values only
  /// [value from the cell's least on][index of a value]: the first step of a shortest way.
  std::vector<std::vector<InputMove>> moves;
  std::vector<Word> readers; ///< transitions that are enabled or not by it
};

/// \pre the system is placed \param dropped transitions that are left out
[[nodiscard]] std::vector<FreeInput>
findFreeInputs(const System& system, const std::vector<Goal>& goals, const Bits& dropped);

} // namespace proskill::verify
