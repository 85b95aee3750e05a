#pragma once

#include "runtime/conform/recorded_run.h"

#include <optional>

namespace proskill::runtime {

/// What a recording claims besides its steps, and the program contradicts.
struct Contradiction {
  std::size_t step = 0; ///< the step of the claim, or the next one
  std::string why;
};

/// Compares the initial values, the messages, and the calls of actions of a recording with those of
/// the program. \return the first contradiction
[[nodiscard]] std::optional<Contradiction> contradiction(const Executable& executable,
                                                         const RecordedRun& run);

} // namespace proskill::runtime
