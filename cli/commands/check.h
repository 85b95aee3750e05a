#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill check`: exit 0 nothing is wrong (hints do not count), 1 errors or warnings, 2 usage,
/// or a file that cannot be read.
void addCheck(CLI::App& app, int& exitCode);

} // namespace proskill::cli
