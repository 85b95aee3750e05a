#pragma once

#include <string_view>

namespace proskill::syntax {

/// The order in which people look for names: `s2` comes before `s10`.
[[nodiscard]] bool isNaturallyBefore(std::string_view a, std::string_view b);

} // namespace proskill::syntax
