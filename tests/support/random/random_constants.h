#pragma once

#include "tests/support/random/form.h"

#include <vector>

namespace proskill::test {

/// The same program with a constant in the place of each number, wherever it is, and their
/// definitions between its own.
[[nodiscard]] std::vector<Form> withConstants(const std::vector<Form>& program);

} // namespace proskill::test
