#include "report/ordered_json.h"

#include "runtime/platform/json.h"

namespace proskill {

OrderedJson parsedJson(std::string_view text) { return runtime::parsedText(text); }

} // namespace proskill
