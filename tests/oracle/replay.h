#pragma once

#include "tests/support/oracle/judge.h"
#include "verify/verify.h"

#include <optional>
#include <string>

namespace proskill::oracle {

/// Replays a trace in the interpreter with exactly its dates: time passes, then a step with the
/// same origins moves the same instances and changes the same variables. Follows all of several
/// equal steps. \return an error; empty on success
[[nodiscard]] std::optional<std::string> replay(const Interpreter& model,
                                                const fiacre::Provenance& provenance,
                                                const fiacre::Pattern& pattern,
                                                const verify::Trace& trace);

} // namespace proskill::oracle
