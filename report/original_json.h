#pragma once

#include "analysis/program/originals.h"
#include "report/ordered_json.h"

namespace proskill::report {

/// `{"file", "line", "column", "what"}`.
[[nodiscard]] OrderedJson originalJson(const analysis::Original& original);
/// The same as a `location` of SARIF, with a message.
[[nodiscard]] OrderedJson sarifOriginal(const analysis::Original& original);

} // namespace proskill::report
