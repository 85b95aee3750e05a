#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/system.h"
#include "verify/verify.h"

namespace proskill::verify {

/// A model, ready to be explored, and what is asked of it.
struct Compiled {
  System system;
  std::vector<Goal> goals; ///< one a question
};

/// Makes the transition system of a model: instances of processes with their variables as cells,
/// every path as code, every synchronisation as a transition; and what is asked of it as nodes over
/// its cells and events.
/// \param limits may be null \throw LimitMet
[[nodiscard]] std::expected<Compiled, Unsupported> compile(const fiacre::Program& program,
                                                           const fiacre::Provenance& provenance,
                                                           const std::vector<Question>& questions,
                                                           LimitWatch* limits = nullptr);

} // namespace proskill::verify
