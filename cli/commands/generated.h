#pragma once

#include "cli/commands/verify_arguments.h"
#include "codegen/model.h"

#include <expected>

namespace proskill::cli {

struct Generated {
  analysis::Program program;
  codegen::Model model;
};

/// Reads a program and generates its model, within the limits of the command. Ranks of `--mpi` do
/// it whatever the limits: others wait for them. The error is the exit code of one that was
/// printed.
[[nodiscard]] std::expected<Generated, int> generated(const VerifyArguments& arguments);

} // namespace proskill::cli
