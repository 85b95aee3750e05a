#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill verify-worker`, which `--help` does not show: the process that verifies for `proskill
/// lsp`.
void addVerifyWorker(CLI::App& app, int& exitCode);

} // namespace proskill::cli
