#pragma once

#include <string_view>

namespace proskill::viz {

/// How wide a line of text in UTF-8 is in DejaVu Sans, and nearly in Verdana, as a multiple of the
/// size of the font. From a table: a picture is the same whatever fonts its computer has.
[[nodiscard]] double textWidth(std::string_view text, bool bold);

} // namespace proskill::viz
