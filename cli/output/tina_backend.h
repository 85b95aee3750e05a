#pragma once

#include "report/verify_report.h"
#include "tina/backend.h"

#include <CLI/CLI.hpp>

#include <expected>

namespace proskill::cli {

enum class Backend : std::uint8_t { Engine, Tina, Both };

/// What a user says of the backend.
struct BackendArguments {
  Backend backend = Backend::Engine;
  tina::ToolChoice tools;
  std::string keep;
  std::string difference = "proskill-difference.md";
};

void addBackend(CLI::App& command, BackendArguments& arguments);

/// What Tina says of a model.
struct TinaReport {
  ide::VerificationReport report;
  tina::Outcome outcome;
};
struct TinaRun {
  tina::Tools tools;
  std::expected<TinaReport, tina::Failure> said;
};

/// Runs the tools on the selected properties, with a line of progress where standard error is a
/// terminal. Where a tool is missing: what, and how to get it, in words.
[[nodiscard]] std::expected<TinaRun, std::string>
runTina(const BackendArguments& arguments, const codegen::Model& model,
        const std::vector<std::string>& properties, const verify::Options& options);

} // namespace proskill::cli
