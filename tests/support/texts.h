#pragma once

#include "analysis/program/program.h"

#include <string>

namespace proskill::test {

/// A program whose only file is `text`.
[[nodiscard]] analysis::Program programOfText(std::string text);

/// Whether the analysis finds no errors. Warnings do not count.
[[nodiscard]] bool isWellFormed(const analysis::Program& program);

} // namespace proskill::test
