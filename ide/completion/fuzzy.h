#pragma once

#include <optional>
#include <string_view>

namespace proskill::ide {

/// How well a name matches the typed letters: it must contain all of them in this order, ignoring
/// case. Greater is better. Letters that begin the name or one of its parts (`goto_waypoint`,
/// `goToWaypoint`) and consecutive letters score most. Nothing if the name does not match; 0 if
/// nothing was typed.
[[nodiscard]] std::optional<int> fuzzyScore(std::string_view typed, std::string_view name);

} // namespace proskill::ide
