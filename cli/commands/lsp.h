#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill lsp`: exits with 0 if the client sent `shutdown` first, 1 if it did not, 2 if the port
/// or the log file cannot be used.
void addLsp(CLI::App& app, int& exitCode);

} // namespace proskill::cli
