#pragma once

#include "verify/trace/witness.h"

#include <cstdint>

namespace proskill::verify {

/// A run without detours that reach the same goal: without steps that lead back to a state where
/// it has been, and without others that it does not need, as far as a few trials show before a
/// limit is met.
/// \param witness of a search without reductions
/// \param effort number of steps that trials may still take, in all; less afterwards
/// \pre the witness confirms the evidence
[[nodiscard]] Evidence shortened(const System& system, const Goal& goal, const Evidence& evidence,
                                 const Witness& witness, std::uint64_t& effort);

} // namespace proskill::verify
