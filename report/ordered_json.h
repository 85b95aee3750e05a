#pragma once

#include "runtime/platform/json.h"

#include <nlohmann/json.hpp>

#include <string_view>

namespace proskill {

/// JSON for people: members keep the order in which they are written.
using OrderedJson = nlohmann::ordered_json;

/// Reads JSON of others. Discarded if it is none, or nested so deep that copies would exhaust the
/// stack: objects that keep their order are copied when they grow.
[[nodiscard]] inline OrderedJson parsedJson(std::string_view text) {
  if (runtime::isTooDeep(text)) return OrderedJson::value_t::discarded;
  return OrderedJson::parse(text, nullptr, false);
}

} // namespace proskill
