#pragma once

#include <string>

namespace proskill::test {

/// Nine skills that anybody may call at any time, unless it was the last one that succeeded. They
/// all share that variable, so the question about deadlocks is practically endless.
[[nodiscard]] std::string endlessProgram();

} // namespace proskill::test
