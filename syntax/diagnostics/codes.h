#pragma once

#include "syntax/diagnostics/diagnostic.h"

namespace proskill::syntax {

/// Every diagnostic that there is, from the one table in diagnostics.def.
enum class Code : std::uint16_t {
#define DIAGNOSTIC(name, code, severity, message, explanation, example) name,
#include "syntax/diagnostics/diagnostics.def"
#undef DIAGNOSTIC
};

} // namespace proskill::syntax
