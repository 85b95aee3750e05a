#include "cli/commands/verify_worker.h"

#include "worker/verify_worker.h"

#include <CLI/CLI.hpp>

namespace proskill::cli {

void addVerifyWorker(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("verify-worker", "Verify for `proskill lsp`");
  command->group("");
  command->callback([&exitCode] { exitCode = worker::runVerifyWorker(); });
}

} // namespace proskill::cli
