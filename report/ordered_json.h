#pragma once

#include <nlohmann/json.hpp>

namespace proskill {

/// JSON for people: members keep the order in which they are written.
using OrderedJson = nlohmann::ordered_json;

} // namespace proskill
