#pragma once

#include "tests/support/oracle/judge.h"
#include "verify/verify.h"

#include <optional>
#include <string>

namespace proskill::oracle {

/// Plays a trace in the interpreter, with exactly the dates that it gives: time passes, then a step
/// that takes the same origins, moves the same instances and changes the same variables. Where
/// several steps look the same, all are followed. Says what went wrong, or nothing.
[[nodiscard]] std::optional<std::string> replay(const Interpreter& model,
                                                const fiacre::Provenance& provenance,
                                                const fiacre::Pattern& pattern,
                                                const verify::Trace& trace);

} // namespace proskill::oracle
