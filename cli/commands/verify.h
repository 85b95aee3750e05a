#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill verify`: exits with 0 if all verdicts are good, 1 if some property is violated, 3 if
/// some are inconclusive because a limit was reached, 2 for wrong usage or a program with errors.
void addVerify(CLI::App& app, int& exitCode);

} // namespace proskill::cli
