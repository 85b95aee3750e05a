#pragma once

namespace CLI {
class App;
}

namespace proskill::cli {

/// `proskill replay`: exits with 0 if all runs are possible and end as expected, 1 if not, 2 for
/// wrong usage.
void addReplay(CLI::App& app, int& exitCode);

} // namespace proskill::cli
