#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill dap`: exits with 0 if the client disconnected, 1 if the connection broke, 2 if the
/// port cannot be used.
void addDap(CLI::App& app, int& exitCode);

} // namespace proskill::cli
