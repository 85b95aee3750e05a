#pragma once

#include "verify/compile/elaborate.h"

namespace proskill::verify {

/// Finds the cells of the variables that the provenance says a user knows. What is not found is
/// left out.
void watch(const fiacre::Provenance& provenance, const Elaboration& model, const Types& types,
           System& system);

/// Makes nodes of the grounds that the provenance gives for its origins. A ground that is not an
/// expression over the main component's variables is skipped: nothing but an explanation is lost.
void addGrounds(const fiacre::Provenance& provenance, const Elaboration& model,
                Expressions& expressions, System& system);

/// A watched variable's value, in words.
[[nodiscard]] std::string shown(const WatchedCell& watched, std::int64_t value);

} // namespace proskill::verify
