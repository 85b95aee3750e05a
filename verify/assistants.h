#pragma once

#include "verify/verify.h"

/// Rank 0 leads a verification, and the others assist: they take part in the searches that it
/// begins, and wait in between.
namespace proskill::verify {

/// Asks the other ranks to take part in searchByRanks() for these questions. Rank 0 calls this.
/// \throw LimitMet if one of them has met a limit
void callAssistants(Ranks& ranks, const std::vector<std::size_t>& questions);
/// Ends assist() on the other ranks. Rank 0 calls this at the end.
void dismissAssistants(Ranks& ranks);

/// Takes part in searches until rank 0 needs no more of them. \return no answers
[[nodiscard]] std::expected<Result, Unsupported> assist(const fiacre::Program& program,
                                                        const fiacre::Provenance& provenance,
                                                        const std::vector<Question>& questions,
                                                        const Options& options);

} // namespace proskill::verify
