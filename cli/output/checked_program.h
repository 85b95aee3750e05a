#pragma once

#include "cli/terminal/paint.h"
#include "codegen/model.h"

#include <optional>
#include <string>

namespace proskill::cli {

/// The program of a root file, for commands that need one without errors: its errors and warnings
/// are printed to standard error. Nothing where it has errors or cannot be read.
[[nodiscard]] std::optional<analysis::Program> loadChecked(const std::string& root,
                                                           ColourChoice colour);

/// Says on standard error why there is no model of a program. The exit code: 2.
int failGeneration(const analysis::Program& program, const codegen::GenerationError& error);

} // namespace proskill::cli
