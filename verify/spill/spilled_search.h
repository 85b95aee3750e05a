#pragma once

#include "verify/explore/search.h"
#include "verify/reduce/prepared.h"
#include "verify/spill_store.h"

namespace proskill::verify {

/// A search in memory; if that does not suffice, the same search again with the graph on disk. Then
/// it skips what it finds to be found already.
/// \pre Options::spill is set
/// \param inMemory see search(); it reports what it finds to `onFound`
[[nodiscard]] SearchResult searchWithSpill(const Prepared& prepared, const std::vector<Goal>& goals,
                                           LimitWatch& limits, const Options& options,
                                           const std::function<SearchResult()>& inMemory,
                                           const OnEvidence& onFound);

} // namespace proskill::verify
