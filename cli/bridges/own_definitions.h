#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proskill::cli {

/// What somebody has added to an imported program, which another import would lose: definitions of
/// kinds that no import writes, as `defproperty mine`. Those that the new text has are not among
/// them.
[[nodiscard]] std::vector<std::string> ownDefinitions(std::string_view existing,
                                                      std::string_view imported);

} // namespace proskill::cli
