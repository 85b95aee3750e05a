#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill lsp`: exit 0 where the client said `shutdown` before it left, 1 where it did not, 2
/// where the port or the log cannot be used.
void addLsp(CLI::App& app, int& exitCode);

} // namespace proskill::cli
