#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill verify-worker`, hidden in `--help`: the process that verifies for `proskill lsp`.
void addVerifyWorker(CLI::App& app, int& exitCode);

} // namespace proskill::cli
