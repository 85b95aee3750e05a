#pragma once

#include "ide/names/place.h"

namespace proskill::ide {

/// The keyword at the end of the path, with its meaning there; null if the word is a name: a state
/// variable may be called `process` or `if`.
[[nodiscard]] const Word* wordAt(const Path& path, std::string_view text);

} // namespace proskill::ide
