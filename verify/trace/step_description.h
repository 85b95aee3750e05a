#pragma once

#include "fiacre/provenance.h"
#include "verify/state/run.h"
#include "verify/verify.h"

/// What is told of a step.
namespace proskill::verify {

/// As frac names transitions; of a synchronisation the later member comes first.
[[nodiscard]] std::string nameOf(const System& system, TransitionId transition, const StepLog& log);

/// The instances of processes that move, in the order of the model.
[[nodiscard]] std::vector<std::string> instancesOf(const System& system, TransitionId transition);

/// Each origin once, in the order of the path; those with words after those without.
[[nodiscard]] std::vector<fiacre::OriginId>
mostDescriptiveLast(const fiacre::Provenance& provenance, const StepLog& log);

/// Every watched variable's value, in `after`.
[[nodiscard]] std::vector<Change> valuesIn(const System& system, const std::vector<Word>& state);

/// \param which watched variables may have changed, by their places
[[nodiscard]] std::vector<Change> changesBetween(const System& system,
                                                 const std::vector<std::uint32_t>& which,
                                                 const std::vector<Word>& before,
                                                 const std::vector<Word>& after);
/// Of all watched variables.
[[nodiscard]] std::vector<Change> changesBetween(const System& system,
                                                 const std::vector<Word>& before,
                                                 const std::vector<Word>& after);

} // namespace proskill::verify
