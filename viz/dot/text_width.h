#pragma once

#include <string_view>

namespace proskill::viz {

/// The width of a line of UTF-8 text in DejaVu Sans, approximately also in Verdana, as a multiple
/// of the font size. It comes from a table, so that pictures do not depend on installed fonts.
[[nodiscard]] double textWidth(std::string_view text, bool bold);

} // namespace proskill::viz
