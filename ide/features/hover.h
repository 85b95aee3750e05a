#pragma once

#include "ide/answers/hover.h"
#include "ide/snapshot/snapshot.h"

#include <optional>

namespace proskill::ide {

/// What is told of the name or the word of the language at a place: the definition, the comment
/// above it, the allowed moves, who sets it, what it can be here. Nothing where no word stands.
[[nodiscard]] std::optional<Hover> hover(const View& view, syntax::Offset at);

} // namespace proskill::ide
