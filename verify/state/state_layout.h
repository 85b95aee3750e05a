#pragma once

#include "verify/model/system.h"

namespace proskill::verify {

/// The system with its cells packed into words: those in `kept` first, the others behind the words
/// that are stored, so that an exploration does not tell states apart by them.
[[nodiscard]] System withStateLayout(System system, const Bits& kept);
/// With every cell kept.
[[nodiscard]] System withStateLayout(System system);

/// The packed initial state.
[[nodiscard]] std::vector<Word> initialState(const System& system);

} // namespace proskill::verify
