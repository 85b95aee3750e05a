#pragma once

#include "ide/answers/hover.h"
#include "ide/snapshot/snapshot.h"
#include "ide/verdicts/verdicts.h"

#include <optional>

namespace proskill::ide {

/// The description of the name or keyword at a place: its definition, the comment above it, the
/// allowed transitions, what sets it, its possible values here, and how long it takes. Nothing if
/// there is no word.
/// \param verdicts of all programs
[[nodiscard]] std::optional<Hover> hover(const View& view, syntax::Offset at,
                                         const Verdicts& verdicts = {});

} // namespace proskill::ide
