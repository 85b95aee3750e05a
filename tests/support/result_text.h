#pragma once

#include "verify/verify.h"

#include <string>

namespace proskill::test {

/// All of a verification that must not depend on the number of threads: counts, verdicts, reasons,
/// and the steps and dates of traces.
[[nodiscard]] std::string textOf(const verify::Result& result);

} // namespace proskill::test
