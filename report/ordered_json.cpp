#include "report/ordered_json.h"

#include "runtime/platform/json.h"

namespace proskill {

OrderedJson parsedJson(std::string_view text) {
  // objects that keep their order are copied when they grow
  if (runtime::isTooDeep(text)) return OrderedJson::value_t::discarded;
  return OrderedJson::parse(text, nullptr, false);
}

} // namespace proskill
