#pragma once

namespace CLI {
class App;
}

/// The subcommands that import and plan programs. Each adds itself to the program, and sets the
/// exit code when it has run.
namespace proskill::cli {

/// `proskill import`: exits with 0 if the program was written, 2 if the file has errors or for
/// wrong usage.
void addImport(CLI::App& app, int& exitCode);

/// `proskill plan`: exits with 0 if a verified plan was written, 2 if there is none, if the goal or
/// the program has errors, or for wrong usage.
void addPlan(CLI::App& app, int& exitCode);

} // namespace proskill::cli
