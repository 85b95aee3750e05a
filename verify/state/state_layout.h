#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// Packs the cells of a system into words. The cells in `kept` come first; the others come after
/// the stored words, so that an exploration does not distinguish states by them.
[[nodiscard]] System withStateLayout(System system, const Bits& kept);
/// The same, with all cells kept.
[[nodiscard]] System withStateLayout(System system);

/// The packed initial state.
[[nodiscard]] std::vector<Word> initialState(const System& system);

} // namespace proskill::verify
