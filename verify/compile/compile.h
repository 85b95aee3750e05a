#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/model/system.h"
#include "verify/verify.h"

namespace proskill::verify {

/// A model, ready to be explored, with its questions.
struct Compiled {
  System system;
  std::vector<Goal> goals; ///< by question
};

/// Compiles a model to its transition system: variables of process instances become cells, each
/// path becomes code, each synchronisation becomes a transition. The questions become goals over
/// cells and events.
/// \param limits may be null
/// \throw LimitMet
[[nodiscard]] std::expected<Compiled, Unsupported> compile(const fiacre::Program& program,
                                                           const fiacre::Provenance& provenance,
                                                           const std::vector<Question>& questions,
                                                           LimitWatch* limits = nullptr);

} // namespace proskill::verify
