#pragma once

#include "tests/meaning/situation.h"

namespace proskill::meaning {

/// The outcomes of a basic skill: those that it declares, and success without a tag if it declares
/// none.
[[nodiscard]] std::vector<Ending> outcomesOf(const syntax::Skill& skill);
/// Of `(success tag)` and `(failure tag)`.
[[nodiscard]] Ending endingOf(const syntax::Skill& skill, const syntax::Statement& statement);
/// At the end of a body.
[[nodiscard]] Ending plainSuccess(const syntax::Skill& skill);
[[nodiscard]] Ending interruptionOf(const syntax::Skill& skill);
[[nodiscard]] Ending failureOf(const syntax::Invariant& invariant);

} // namespace proskill::meaning
