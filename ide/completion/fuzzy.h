#pragma once

#include <optional>
#include <string_view>

namespace proskill::ide {

/// How well a name matches what was typed: every letter of it in this order, case aside. Greater is
/// better; letters that begin the name or a part of it (`goto_waypoint`, `goToWaypoint`) and
/// letters in a row count most. Nothing where it does not match; 0 where nothing was typed.
[[nodiscard]] std::optional<int> fuzzyScore(std::string_view typed, std::string_view name);

} // namespace proskill::ide
