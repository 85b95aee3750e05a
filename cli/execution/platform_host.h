#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill platform-host`, which `--help` does not show: the process in which `proskill run` has
/// a shared library perform the actions.
void addPlatformHost(CLI::App& app, int& exitCode);

} // namespace proskill::cli
