#pragma once

#include "cli/terminal/paint.h"
#include "codegen/model.h"
#include "verify/verify.h"

#include <optional>
#include <string>

namespace proskill::cli {

/// Loads a program for commands that need one without errors, and prints its errors and warnings to
/// standard error. Nothing if it has errors or cannot be read.
[[nodiscard]] std::optional<analysis::Program> loadChecked(const std::string& root,
                                                           ColourChoice colour);

/// Prints to standard error why a program has no model. \return kFailed
int failGeneration(const analysis::Program& program, const codegen::GenerationError& error);

/// Prints to standard error why the engine cannot explore a model. \return kFailed
int failUnsupported(const verify::Unsupported& error);

} // namespace proskill::cli
