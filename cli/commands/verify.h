#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill verify`: exit 0 all good, 1 something is violated, 3 something is open because a limit
/// was met, 2 usage, or a program with errors.
void addVerify(CLI::App& app, int& exitCode);

} // namespace proskill::cli
