#pragma once

#include "ide/answers/hover.h"
#include "ide/snapshot/snapshot.h"

#include <optional>

namespace proskill::ide {

/// The description of the name or keyword at a place: its definition, the comment above it, the
/// allowed transitions, what sets it, and its possible values here. Nothing if there is no word.
[[nodiscard]] std::optional<Hover> hover(const View& view, syntax::Offset at);

} // namespace proskill::ide
