#pragma once

#include "analysis/program/program.h"

namespace proskill::analysis {

/// Determines the values of the constants, and puts them into the definitions that mention them.
/// A constant whose name has another meaning in the program is not filled in.
void fillInConstants(Program& program);

/// Whether the constants have the same names and values in both programs.
[[nodiscard]] bool haveSameConstants(const Program& a, const Program& b);

} // namespace proskill::analysis
