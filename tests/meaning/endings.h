#pragma once

#include "tests/meaning/situation.h"

namespace proskill::meaning {

/// The outcomes that a basic skill may have by itself: those that it declares; without a success,
/// one without a tag.
[[nodiscard]] std::vector<Ending> outcomesOf(const syntax::Skill& skill);
/// Of `(success tag)` and `(failure tag)`.
[[nodiscard]] Ending endingOf(const syntax::Skill& skill, const syntax::Statement& statement);
/// At the end of a body.
[[nodiscard]] Ending plainSuccess(const syntax::Skill& skill);
[[nodiscard]] Ending interruptionOf(const syntax::Skill& skill);
[[nodiscard]] Ending failureOf(const syntax::Invariant& invariant);

} // namespace proskill::meaning
