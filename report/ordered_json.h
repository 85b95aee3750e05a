#pragma once

#include <nlohmann/json.hpp>

#include <string_view>

namespace proskill {

/// JSON for people: members keep the order in which they are written.
using OrderedJson = nlohmann::ordered_json;

/// Reads JSON of others. Discarded if it is none, or nested too deep.
[[nodiscard]] OrderedJson parsedJson(std::string_view text);

} // namespace proskill
