#pragma once

#include "report/verify_report.h"
#include "tina/backend.h"

#include <CLI/CLI.hpp>

#include <expected>

namespace proskill::cli {

enum class Backend : std::uint8_t { Engine, Tina, Both };

/// The options that select the backend.
struct BackendArguments {
  Backend backend = Backend::Engine;
  tina::ToolChoice tools;
  std::string keep;
  std::string difference = "proskill-difference.md";
};

void addBackend(CLI::App& command, BackendArguments& arguments);

/// The results of Tina for a model.
struct TinaReport {
  ide::VerificationReport report;
  tina::Outcome outcome;
};
struct TinaRun {
  tina::Tools tools;
  std::expected<TinaReport, tina::Failure> said;
};

/// Runs the tools on the selected properties and shows a progress line if standard error is a
/// terminal. If a tool is missing, the error says which one and how to get it.
[[nodiscard]] std::expected<TinaRun, std::string>
runTina(const BackendArguments& arguments, const codegen::Model& model,
        const std::vector<std::string>& properties, const verify::Options& options);

} // namespace proskill::cli
