#pragma once

#include "syntax/text/rational.h"

#include <string>

namespace proskill::syntax {

/// A number of seconds for people: `4 s`, `0.25 s`, or `about 2.09 s (23/11)`.
[[nodiscard]] std::string secondsText(Rational value);

} // namespace proskill::syntax
