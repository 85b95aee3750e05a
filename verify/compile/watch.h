#pragma once

#include "verify/compile/elaborate.h"

namespace proskill::verify {

/// Finds the cells of the variables that the provenance shows to users. Variables without a cell
/// are skipped.
void watch(const fiacre::Provenance& provenance, const Elaboration& model, const Types& types,
           System& system);

/// Compiles the grounds of the provenance's origins. Skips a ground that is not an expression over
/// the main component's variables; only an explanation is lost.
void addGrounds(const fiacre::Provenance& provenance, const Elaboration& model,
                Expressions& expressions, System& system);

/// The text of a watched variable's value.
[[nodiscard]] std::string shown(const WatchedCell& watched, std::int64_t value);

} // namespace proskill::verify
