#pragma once

#include "ide/names/place.h"

namespace proskill::ide {

/// The word of the language that the path ends in, by the meaning that it has there; null where it
/// is none: a state variable may well be called `process` or `if`.
[[nodiscard]] const Word* wordAt(const Path& path, std::string_view text);

} // namespace proskill::ide
