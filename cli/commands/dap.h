#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill dap`: exit 0 where the client disconnected, 1 where it was gone before, 2 where the
/// port cannot be used.
void addDap(CLI::App& app, int& exitCode);

} // namespace proskill::cli
