#pragma once

#include "verify/explore/search.h"
#include "verify/ranks.h"
#include "verify/reduce/prepared.h"

namespace proskill::verify {

/// The same as search(), by several processes. All ranks call this with equal arguments. Rank 0
/// returns the result and receives the evidence; the other ranks return their part of it.
SearchResult searchByRanks(const Prepared& prepared, const std::vector<Goal>& goals,
                           LimitWatch& limits, Ranks& ranks, const OnEvidence& onFound);

} // namespace proskill::verify
