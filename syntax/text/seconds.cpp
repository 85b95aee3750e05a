#include "syntax/text/seconds.h"

#include <fmt/format.h>

namespace proskill::syntax {

std::string secondsText(Rational value) {
  const auto exact = toString(value);
  if (!exact.contains('/')) return exact + " s";
  const auto rounded =
      static_cast<double>(value.numerator) / static_cast<double>(value.denominator);
  const bool isSmall =
      -0.1 < rounded && rounded < 0.1; // two digits after the point show too little
  return isSmall ? fmt::format("about {:.2g} s ({})", rounded, exact)
                 : fmt::format("about {:.2f} s ({})", rounded, exact);
}

} // namespace proskill::syntax
