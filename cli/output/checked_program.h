#pragma once

#include "cli/terminal/paint.h"
#include "codegen/model.h"
#include "verify/verify.h"

#include <optional>
#include <string>

namespace proskill::cli {

/// The program of a root file, for commands that need one without errors: its errors and warnings
/// are printed to standard error. Nothing where it has errors or cannot be read.
[[nodiscard]] std::optional<analysis::Program> loadChecked(const std::string& root,
                                                           ColourChoice colour);

/// Says on standard error why there is no model of a program. \return kFailed
int failGeneration(const analysis::Program& program, const codegen::GenerationError& error);

/// Says on standard error why the engine cannot explore a model. \return kFailed
int failUnsupported(const verify::Unsupported& error);

} // namespace proskill::cli
