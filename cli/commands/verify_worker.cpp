#include "cli/commands/commands.h"

#include "worker/verify_worker.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace proskill::cli {

void addVerifyWorker(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("verify-worker", "Verify for `proskill lsp`");
  command->group("");
  auto cache = std::make_shared<std::string>();
  command->add_option("--cache", *cache, "The directory where verdicts are kept");
  command->callback([cache, &exitCode] { exitCode = worker::runVerifyWorker(*cache); });
}

} // namespace proskill::cli
