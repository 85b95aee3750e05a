#pragma once

#include "fiacre/provenance.h"
#include "verify/state/run.h"
#include "verify/verify.h"

/// Names and descriptions of steps.
namespace proskill::verify {

/// The name that frac gives a transition; in a synchronisation the later member comes first.
[[nodiscard]] std::string nameOf(const System& system, TransitionId transition, const StepLog& log);

/// The process instances that move, in the order of the model.
[[nodiscard]] std::vector<std::string> instancesOf(const System& system, TransitionId transition);

/// Each origin once, in the order of the path: first those without a description, then those with
/// one.
[[nodiscard]] std::vector<fiacre::OriginId>
mostDescriptiveLast(const fiacre::Provenance& provenance, const StepLog& log);

/// The value of each watched variable, in `after`.
[[nodiscard]] std::vector<Change> valuesIn(const System& system, const std::vector<Word>& state);

/// \param which indices of the watched variables that may have changed
[[nodiscard]] std::vector<Change> changesBetween(const System& system,
                                                 const std::vector<std::uint32_t>& which,
                                                 const std::vector<Word>& before,
                                                 const std::vector<Word>& after);
/// The same for all watched variables.
[[nodiscard]] std::vector<Change> changesBetween(const System& system,
                                                 const std::vector<Word>& before,
                                                 const std::vector<Word>& after);

} // namespace proskill::verify
